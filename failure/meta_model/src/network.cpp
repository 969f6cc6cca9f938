// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/meta_model/network.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "features.hpp"

namespace brash::meta_model {
namespace {

/// Rows that are computed together. A single row is computed as a whole lane too, so that it gets the same bits.
constexpr int kLane = 8;
using Lane = Eigen::Array<double, kLane, 1>;

/// Keeps the logarithm of b / l_c finite at the straight edge; the depth below which the edge is nearly straight.
constexpr double kDepthShift = 0.1;

/// The features of network.hpp, in its order.
std::array<Lane, kInputs> features(const std::array<Lane, kInputs>& x) {
  const Lane &b = x[0], &c = x[1], &theta = x[2], &mu1 = x[3], &mu2 = x[4];
  const Lane width_ratio = 1.0 + 2.0 * b * (0.5 * theta).tan() / c;
  return {Lane((b + kDepthShift).log()), Lane(c.log()), Lane(width_ratio.log()), Lane(mu1.log()), Lane(mu2.square())};
}

/// Eq. 17 for a lane of rows.
std::array<Lane, kOutputs> forward(const NetworkParameters& p, const std::array<Lane, kInputs>& raw) {
  const std::array<Lane, kInputs> values = features(raw);
  std::array<Lane, kInputs> x;
  for (int i = 0; i < kInputs; ++i) x[i] = (values[i] - p.features[i].offset) / p.features[i].factor;
  std::array<Lane, kOutputs> y;
  for (int k = 0; k < kOutputs; ++k) y[k] = Lane::Constant(p.b2[k]);
  for (int j = 0; j < p.hidden; ++j) {
    Lane a = Lane::Constant(p.b1[j]);
    for (int i = 0; i < kInputs; ++i) a += p.w1[j * kInputs + i] * x[i];
    const Lane s = 1.0 / (1.0 + (-a).exp());
    for (int k = 0; k < kOutputs; ++k) y[k] += p.w2[k * p.hidden + j] * s;
  }
  for (int k = 0; k < kOutputs; ++k) y[k] = y[k] * p.targets[k].factor + p.targets[k].offset;
  y[0] = y[0].exp();
  return y;
}

/// Whether the features of `x` are finite.
bool has_features(const Input& x) {
  return x.b_lc >= 0.0 && x.c_lc > 0.0 && x.theta >= 0.0 && x.theta < kPi && x.mu1 > 0.0 && std::isfinite(x.mu2);
}

bool finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

}  // namespace

std::array<double, kInputs> features_of(const Input& input) {
  std::array<Lane, kInputs> lanes;
  const auto x = to_array(input);
  for (int i = 0; i < kInputs; ++i) lanes[i] = Lane::Constant(x[i]);
  const auto values = features(lanes);
  std::array<double, kInputs> result{};
  for (int i = 0; i < kInputs; ++i) result[i] = values[i][0];
  return result;
}

Network::Network(NetworkParameters parameters) : parameters_(std::move(parameters)) {
  const NetworkParameters& p = parameters_;
  const auto hidden = static_cast<std::size_t>(p.hidden);
  BRASH_EXPECTS(p.hidden > 0, p.hidden);
  BRASH_EXPECTS(p.w1.size() == hidden * kInputs && p.b1.size() == hidden, p.w1.size(), p.b1.size());
  BRASH_EXPECTS(p.w2.size() == hidden * kOutputs && p.b2.size() == kOutputs, p.w2.size(), p.b2.size());
  BRASH_EXPECTS(finite(p.w1) && finite(p.b1) && finite(p.w2) && finite(p.b2));
  BRASH_EXPECTS(p.thickness_over_lc > 0.0, p.thickness_over_lc);
  for (const Normalisation& n : p.features)
    BRASH_EXPECTS(std::isfinite(n.offset) && n.factor > 0.0, n.offset, n.factor);
  for (const Normalisation& n : p.targets) BRASH_EXPECTS(std::isfinite(n.offset) && n.factor > 0.0, n.offset, n.factor);
  const auto lower = to_array(p.range.lower), upper = to_array(p.range.upper);
  for (int i = 0; i < kInputs; ++i) BRASH_EXPECTS(lower[i] <= upper[i], i, lower[i], upper[i]);
  BRASH_EXPECTS(has_features(p.range.lower) && has_features(p.range.upper));
}

void Network::predict(std::span<const Input> inputs, std::span<Output> outputs) const {
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
    const auto y = forward(parameters_, x);
    for (std::size_t row = 0; row < n; ++row) {
      outputs[from + row] = {y[0][static_cast<Eigen::Index>(row)], y[1][static_cast<Eigen::Index>(row)]};
    }
  }
}

Output Network::predict(const Input& input) const {
  Output output;
  predict(std::span(&input, 1), std::span(&output, 1));
  return output;
}

RangeCheck Network::check(const Input& input) const {
  const auto x = to_array(input), lower = to_array(range().lower), upper = to_array(range().upper);
  RangeCheck result;
  for (int i = 0; i < kInputs; ++i) {
    result.below |= x[i] < lower[i];
    result.above |= x[i] > upper[i];
  }
  return result;
}

Input Network::clamp(const Input& input) const {
  auto x = to_array(input);
  const auto lower = to_array(range().lower), upper = to_array(range().upper);
  for (int i = 0; i < kInputs; ++i) {
    BRASH_EXPECTS(!std::isnan(x[i]), i);
    x[i] = std::clamp(x[i], lower[i], upper[i]);
  }
  return to_input(x);
}

}  // namespace brash::meta_model
