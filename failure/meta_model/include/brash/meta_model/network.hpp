// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

namespace brash::meta_model {

/// The five inputs of Eq. 17.
struct Input {
  double b_lc = 0.0;   ///< b / l_c [-]
  double c_lc = 0.0;   ///< c / l_c [-]
  double theta = 0.0;  ///< [rad]
  double mu1 = 0.0;    ///< out-of-plane over in-plane normal load [-]
  double mu2 = 0.0;    ///< in-plane friction over in-plane normal load [-]
};

/// The two outputs of Eq. 17.
struct Output {
  double sigma_over_p = 0.0;
  double lbreak_over_lc = 0.0;
};

/// Box that the training inputs fill.
struct Range {
  Input lower;
  Input upper;
};

/// Where an input lies against the range: the paper clamps below and shortens the step above (Sec. 2.2.2).
struct RangeCheck {
  bool below = false;
  bool above = false;
  bool inside() const { return !below && !above; }
};

/// The paper's network, Eq. 17: y = W2 S(W1 X + b1) + b2 with X, y normalised and S the logistic sigmoid.
class Network {
 public:
  /// Reads a model file written by `brash failure train`.
  /// @throws InputError naming the file, the place and what is wrong (also when its hash does not fit).
  static Network read(const std::string& path);

  Output predict(const Input& input) const;
  /// `outputs[i] = predict(inputs[i])`; shapes=(n,).
  void predict(std::span<const Input> inputs, std::span<Output> outputs) const;

  const Range& range() const { return range_; }
  RangeCheck check(const Input& input) const;
  /// `input` moved into the range.
  Input clamp(const Input& input) const;
  /// h / l_c for which the network was trained [-]; the stress is scaled from it by Eq. 19.
  double thickness_over_lc() const { return thickness_over_lc_; }

 private:
  Range range_;
  double thickness_over_lc_ = 0.1;
};

}  // namespace brash::meta_model
