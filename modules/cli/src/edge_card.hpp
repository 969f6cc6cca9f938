// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace brash::cli {

/// Files of a model of a moving edge.
struct EdgeFiles {
  std::string database;    ///< of whole sheets
  std::string split;       ///< of split sheets, or empty
  std::string test;        ///< geometries that the model has not seen, or empty
  std::string test_split;  ///< split ones, or empty
  std::string output;      ///< model; its card and errors are written beside it
  std::string command;     ///< that makes the model
};

/// Fits the model, tests it on the test databases, writes model, card and errors and prints the errors.
/// @throws InputError for a database that cannot be read or leaves a point of its grid out.
void fit_edges(const EdgeFiles& files);

}  // namespace brash::cli
