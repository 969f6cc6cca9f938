// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brash/database/database.hpp"
#include "brash/meta_model/profile_model.hpp"
#include "brash/plate/plate.hpp"

namespace brash::cli {

/// One row that the model has not seen, and its errors.
struct JudgedRow {
  const plate::WedgePlate* plate = nullptr;  ///< of a record
  double sigma_over_p = 0.0;
  double stress_error = 0.0;  ///< size of predicted / computed - 1
  double length_error = 0.0;  ///< over l_c
  bool on_plateau = false;    ///< the predicted place has at least 99 % of the peak stress
};

/// The errors of `model` on the rows of `records`, inputs moved into its range.
std::vector<JudgedRow> judge(const meta_model::ProfileModel& model,
                             const std::vector<const database::Record*>& records);

/// Two lines for the terminal: all rows, and those where ice bends before it is crushed.
std::string summary(const std::vector<JudgedRow>& rows);

/// What the card of a superposition says besides the errors.
struct ProfileCardContext {
  std::string model_file;
  std::string content_sha256;
  std::string database_file;
  std::string data_sha256;
  std::string test;  ///< which rows judge it
  std::size_t n_geometries = 0;
};

/// The model card (Markdown): errors on `rows`, overall and by region.
std::string profile_card(const meta_model::ProfileModel& model, const std::vector<JudgedRow>& rows,
                         const ProfileCardContext& context);

}  // namespace brash::cli
