// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/meta_model/features.hpp"

#include <algorithm>
#include <cmath>

#include "brash/core/constants.hpp"
#include "lane.hpp"

namespace brash::meta_model {
namespace {

/// Keeps the logarithm of b / l_c finite at the straight edge; the depth below which the edge is nearly straight.
constexpr double kDepthShift = 0.1;

/// `value` of |b|, reflected at the value of the straight edge for a bay.
Lane reflected(const Lane& b, const Lane& value, double straight) {
  return (b < 0.0).select(2.0 * straight - value, value);
}

}  // namespace

std::array<Lane, kInputs> features_of(const std::array<Lane, kInputs>& x) {
  const Lane &b = x[0], &c = x[1], &theta = x[2], &mu1 = x[3], &mu2 = x[4];
  const Lane deep = b.abs(), width_ratio = 1.0 + 2.0 * deep * (0.5 * theta).tan() / c;
  return {reflected(b, (deep + kDepthShift).log(), std::log(kDepthShift)), Lane(c.log()),
          reflected(b, width_ratio.log(), 0.0), Lane(mu1.log()), Lane(mu2.square())};
}

std::array<Lane, kInputs> lanes_of(const Input& input) {
  std::array<Lane, kInputs> lanes;
  const auto x = to_array(input);
  for (int i = 0; i < kInputs; ++i) lanes[i] = Lane::Constant(x[i]);
  return lanes;
}

std::array<double, kInputs> features_of(const Input& input) { return first_of(features_of(lanes_of(input))); }

bool has_features(const Input& x) {
  return std::isfinite(x.b_lc) && x.c_lc > 0.0 && x.theta >= 0.0 && x.theta < kPi && x.mu1 > 0.0 &&
         std::isfinite(x.mu2);
}

bool finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

void expect_valid(const Normalisation& n) {
  BRASH_EXPECTS(std::isfinite(n.offset) && n.factor > 0.0, n.offset, n.factor);
}

void expect_valid(const Range& range) {
  const auto lower = to_array(range.lower), upper = to_array(range.upper);
  for (int i = 0; i < kInputs; ++i) BRASH_EXPECTS(lower[i] <= upper[i], i, lower[i], upper[i]);
  BRASH_EXPECTS(has_features(range.lower) && has_features(range.upper));
}

}  // namespace brash::meta_model
