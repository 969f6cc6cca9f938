// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/meta_model/network.hpp"

#include <algorithm>
#include <cmath>

#include "brash/core/contract.hpp"
#include "brash/meta_model/features.hpp"
#include "lane.hpp"

namespace brash::meta_model {
namespace {

/// Eq. 17 for a lane of rows.
std::array<Lane, kOutputs> forward(const NetworkParameters& p, const std::array<Lane, kInputs>& raw) {
  const std::array<Lane, kInputs> values = features_of(raw);
  std::array<Lane, kInputs> x;
  for (int i = 0; i < kInputs; ++i) x[i] = (values[i] - p.features[i].offset) / p.features[i].factor;
  std::array<Lane, kOutputs> y;
  for (int k = 0; k < kOutputs; ++k) y[k] = Lane::Constant(p.b2[k]);
  for (int j = 0; j < p.hidden; ++j) {
    Lane a = Lane::Constant(p.b1[j]);
    for (int i = 0; i < kInputs; ++i) a += p.w1[j * kInputs + i] * x[i];
    const Lane s = sigmoid(a);
    for (int k = 0; k < kOutputs; ++k) y[k] += p.w2[k * p.hidden + j] * s;
  }
  for (int k = 0; k < kOutputs; ++k) y[k] = y[k] * p.targets[k].factor + p.targets[k].offset;
  y[0] = y[0].exp();
  return y;
}

}  // namespace

Network::Network(NetworkParameters parameters) : parameters_(std::move(parameters)) {
  const NetworkParameters& p = parameters_;
  const auto hidden = static_cast<std::size_t>(p.hidden);
  BRASH_EXPECTS(p.hidden > 0, p.hidden);
  BRASH_EXPECTS(p.w1.size() == hidden * kInputs && p.b1.size() == hidden, p.w1.size(), p.b1.size());
  BRASH_EXPECTS(p.w2.size() == hidden * kOutputs && p.b2.size() == kOutputs, p.w2.size(), p.b2.size());
  BRASH_EXPECTS(finite(p.w1) && finite(p.b1) && finite(p.w2) && finite(p.b2));
  BRASH_EXPECTS(p.thickness_over_lc > 0.0, p.thickness_over_lc);
  for (const Normalisation& n : p.features) expect_valid(n);
  for (const Normalisation& n : p.targets) expect_valid(n);
  expect_valid(p.range);
}

void Network::predict(std::span<const Input> inputs, std::span<Output> outputs) const {
  by_lanes(inputs, outputs, [this](const std::array<Lane, kInputs>& x) { return forward(parameters_, x); });
}

Output ResponseNetwork::predict(const Input& input) const {
  Output output;
  predict(std::span(&input, 1), std::span(&output, 1));
  return output;
}

RangeCheck ResponseNetwork::check(const Input& input) const {
  const auto x = to_array(input), lower = to_array(range().lower), upper = to_array(range().upper);
  RangeCheck result;
  for (int i = 0; i < kInputs; ++i) {
    result.below |= x[i] < lower[i];
    result.above |= x[i] > upper[i];
  }
  return result;
}

Input ResponseNetwork::clamp(const Input& input) const {
  auto x = to_array(input);
  const auto lower = to_array(range().lower), upper = to_array(range().upper);
  for (int i = 0; i < kInputs; ++i) {
    BRASH_EXPECTS(!std::isnan(x[i]), i);
    x[i] = std::clamp(x[i], lower[i], upper[i]);
  }
  return to_input(x);
}

}  // namespace brash::meta_model
