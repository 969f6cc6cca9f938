// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <span>

#include "brash/core/contract.hpp"
#include "brash/meta_model/features.hpp"

namespace brash::meta_model {

/// Rows that are computed together. A single row is computed as a whole lane too, so that it gets the same bits.
inline constexpr int kLane = 8;
using Lane = Eigen::Array<double, kLane, 1>;

/// The features of network.hpp, in its order, not yet normalised.
std::array<Lane, kInputs> features_of(const std::array<Lane, kInputs>& input);

/// The same of hump_network.hpp.
using HumpLanes = std::array<Lane, kHumpFeatures>;
HumpLanes hump_features_of(const std::array<Lane, kInputs>& input);

/// `input` in every row of a lane.
std::array<Lane, kInputs> lanes_of(const Input& input);
/// The first row.
template <std::size_t N>
std::array<double, N> first_of(const std::array<Lane, N>& lanes) {
  std::array<double, N> row{};
  for (std::size_t i = 0; i < N; ++i) row[i] = lanes[i][0];
  return row;
}

/// The logistic sigmoid.
inline Lane sigmoid(const Lane& a) { return 1.0 / (1.0 + (-a).exp()); }

/// outputs[i] = forward(inputs[i]) for lanes of rows.
template <typename Forward>
void by_lanes(std::span<const Input> inputs, std::span<Output> outputs, Forward forward) {
  BRASH_EXPECTS(inputs.size() == outputs.size(), inputs.size(), outputs.size());
  std::array<Lane, kInputs> x;
  for (std::size_t from = 0; from < inputs.size(); from += kLane) {
    const std::size_t n = std::min<std::size_t>(kLane, inputs.size() - from);
    // The last row fills a lane that is not full.
    for (std::size_t row = 0; row < kLane; ++row) {
      const Input& input = inputs[from + std::min(row, n - 1)];
      BRASH_EXPECTS(has_features(input), input.b_lc, input.c_lc, input.theta, input.mu1, input.mu2);
      const auto values = to_array(input);
      for (int i = 0; i < kInputs; ++i) x[i][static_cast<Eigen::Index>(row)] = values[i];
    }
    const std::array<Lane, kOutputs> y = forward(x);
    for (std::size_t row = 0; row < n; ++row) {
      outputs[from + row] = {y[0][static_cast<Eigen::Index>(row)], y[1][static_cast<Eigen::Index>(row)]};
    }
  }
}

}  // namespace brash::meta_model
