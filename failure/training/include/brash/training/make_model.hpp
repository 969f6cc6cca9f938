// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "brash/training/hump_training.hpp"
#include "brash/training/network_training.hpp"

namespace brash::training {

/// Files of a model that is made. Its card and its errors are written beside it.
struct ModelFiles {
  std::string data;        ///< database; of a deep network a plan
  std::string test;        ///< database of geometries that the model has not seen, or empty
  std::string split;       ///< database of the split sheets of a moving edge, or empty
  std::string test_split;  ///< database that tests them, or empty
  std::string output;      ///< model (JSON)
  std::string command;     ///< that makes the model, for its card
};

struct MadeModel {
  std::string report;          ///< errors and fits, lines for people
  std::string content_sha256;  ///< of the model file
  std::string card;            ///< path of the card
};

/// The model card (Markdown) beside the model's file.
std::string card_file(const std::string& model);
/// The errors by range (CSV) beside the model's file.
std::string errors_file(const std::string& model);

// Each makes a model and writes it with its card.
// @throws InputError for a database or a plan that cannot be read, or that does not fit the kind of model.

/// The network of Eq. 17.
MadeModel make_network(const ModelFiles& files, TrainingOptions options);
/// A superposition of unit profiles. Without a test, a fit without every eleventh geometry is judged on these.
MadeModel make_superposition(const ModelFiles& files);
/// A deep network on the points of a plan, answered by the superposition that comes with the program.
MadeModel make_deep_network(const ModelFiles& files, HumpTrainingOptions options);
/// The model of a moving edge.
MadeModel make_edge_model(const ModelFiles& files);

}  // namespace brash::training
