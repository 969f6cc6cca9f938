// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "brash/meta_model/edge_responses.hpp"
#include "brash/plate/edge_responses.hpp"

namespace brash::failure {

using meta_model::EdgeResponseModel;
using plate::EdgeGeometry;
using plate::EdgeResponses;
using plate::series_weights;
using plate::SeriesWeights;

/// Responses of moving edges from a model, or from the plate on its water (one to five seconds each).
class EdgeSource {
 public:
  /// @param model  file of a model; empty: the one that comes with the program; `fem`: the plate.
  /// @throws InputError when the file cannot be read.
  explicit EdgeSource(const std::string& model);

  struct Answer {
    EdgeResponses responses;
    bool in_range = true;  ///< else an input was moved into the model's range
  };
  /// A contact shorter than the model's shortest keeps its force, not its line load: away from the tip only the force
  /// counts.
  /// @throws RunError when the plate cannot be solved.
  Answer at(const EdgeGeometry& geometry) const;

 private:
  std::optional<EdgeResponseModel> model_;
};

/// The file of the EdgeResponseModel that comes with the program; found as model_path() finds its files.
std::string edge_model_path();

}  // namespace brash::failure
