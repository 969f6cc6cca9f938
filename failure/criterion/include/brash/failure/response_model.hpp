// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "brash/meta_model/network.hpp"

namespace brash::failure {

/// Eq. 19 scales a network's stress to another h / l_c, which is right for its bending alone. Against the plate the
/// stress was 23 % off at three times the h / l_c of the training. A network is out of its range beyond this share of
/// its own h / l_c, and a case gets the warning trained-thickness.
inline constexpr double kThicknessScaled = 0.2;

/// The answer of a failure model to one row of the inputs of Eq. 17.
struct ModelResponse {
  double sigma_over_p = 0.0;    ///< [-]
  double lbreak_over_lc = 0.0;  ///< [-]
  /// False: an input was moved into the model's range, a network's stress was scaled too far
  /// (kThicknessScaled), or the ice is thicker than l_c and no plate.
  bool in_range = true;
};

/// A failure model without a case: dimensionless inputs in, dimensionless outputs out. Stateless after construction.
class ResponseModel {
 public:
  virtual ~ResponseModel() = default;

  /// @param input              b_lc (negative: a bay), c_lc > 0, theta in [0, pi), mu1 > 0, all finite.
  /// @param thickness_over_lc  h / l_c [-], > 0; 0: the ratio of the training rows, 0.1 for plate and superposition.
  /// @throws RunError when the plate cannot be solved.
  virtual ModelResponse respond(const meta_model::Input& input, double thickness_over_lc = 0.0) const = 0;
};

/// @param model  `fem`: the plate is solved for each row (about a third of a second); `network`, `deep-network` or
///               `superposition`: the model that comes with the program; else the path of a model file.
/// @throws InputError naming the file and the error.
std::unique_ptr<ResponseModel> make_response_model(const std::string& model);

}  // namespace brash::failure
