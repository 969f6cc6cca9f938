// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "brash/meta_model/profile_model.hpp"
#include "brash/plate/plate.hpp"
#include "brash/training/database.hpp"
#include "brash/training/hump_training.hpp"

namespace brash::training {

/// The name of a file without its folders.
std::string file_name(const std::string& path);

/// A model card and the errors that it summarises.
struct ModelCard {
  std::string text;    ///< Markdown
  std::string errors;  ///< CSV, or empty
};

/// Writes card and errors beside the model `model`; the card's path.
std::string write_card(const std::string& model, const ModelCard& card);

/// One row that the model has not seen, and its errors.
struct JudgedRow {
  const plate::WedgePlate* plate = nullptr;  ///< of a record
  double sigma_over_p = 0.0;
  double stress_error = 0.0;  ///< size of predicted / computed - 1
  double length_error = 0.0;  ///< over l_c
  bool on_plateau = false;    ///< the predicted place has at least 99 % of the peak stress
};

/// The answers of a model to the inputs of Eq. 17 and h / l_c.
using Answers = std::function<meta_model::Output(const meta_model::Input&, double)>;

/// Inputs moved into the model's range. The model must outlive the result.
Answers answers_of(const meta_model::ProfileModel& model);
/// The same; the stress is scaled by Eq. 19 from the h / l_c of the training.
Answers answers_of(const meta_model::ResponseNetwork& model);

/// The errors of a model on the rows of `records`.
std::vector<JudgedRow> judge(const Answers& model, const std::vector<const Record*>& records);

/// Two lines for the terminal: all rows, and those where ice bends before it is crushed.
std::string summary(const std::vector<JudgedRow>& rows);

/// The facts on the card of a model besides the errors.
struct CardFacts {
  std::string model_file;
  std::string content_sha256;
  std::string database_file;
  std::string data_sha256;
  std::string test;           ///< which rows the errors are of
  std::string errors_file;    ///< name of the errors by range
  std::string command;        ///< that makes the model
  std::size_t n_learned = 0;  ///< geometries of a superposition, rows of a network
};

/// The model card, and the errors on `rows` by range.
ModelCard profile_card(const meta_model::ProfileModel& model, const std::vector<JudgedRow>& rows,
                       const CardFacts& facts);

/// The same for a HumpNetwork.
ModelCard hump_card(const TrainedHumps& trained, const std::vector<JudgedRow>& rows, const CardFacts& facts);

}  // namespace brash::training
