// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/meta_model/hump_network.hpp"

#include "lane.hpp"

namespace brash::meta_model {
namespace {

/// One layered network for a lane of rows; `kMostUnits` bounds the width of a hidden layer.
Lane forward(const LayeredNetwork& network, const std::vector<int>& hidden, const HumpLanes& x) {
  std::array<Lane, kMostUnits> from, to;
  std::copy(x.begin(), x.end(), from.begin());
  int n = kHumpFeatures;
  const double* w = network.weights.data();
  const auto linear = [&](const double* row, double offset) {
    Lane a = Lane::Constant(offset);
    for (int i = 0; i < n; ++i) a += row[i] * from[static_cast<std::size_t>(i)];
    return a;
  };
  for (const int units : hidden) {
    const double* b = w + units * n;
    for (int j = 0; j < units; ++j) to[static_cast<std::size_t>(j)] = sigmoid(linear(w + j * n, b[j]));
    from.swap(to);
    n = units;
    w = b + units;
  }
  return linear(w, w[n]) * network.target.factor + network.target.offset;
}

/// The answers of the two humps; the larger stress wins.
std::array<Lane, kOutputs> forward(const HumpParameters& p, const std::array<Lane, kInputs>& input) {
  HumpLanes x = hump_features_of(input);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = (x[i] - p.features[i].offset) / p.features[i].factor;
  const Lane near = forward(p.stress[0], p.hidden, x), far = forward(p.stress[1], p.hidden, x);
  const auto far_wins = (far > near).eval();
  const Lane place =
      far_wins.select(forward(p.place[1], p.hidden, x), forward(p.place[0], p.hidden, x)).exp() - kPlaceShift;
  return {Lane(near.max(far).exp()), Lane(place.max(0.0))};
}

}  // namespace

HumpLanes hump_features_of(const std::array<Lane, kInputs>& input) {
  const auto shared = features_of(input);
  HumpLanes x;
  std::copy(shared.begin(), shared.end(), x.begin());
  x.back() = (1.0 + 2.0 * input[0] / input[1]).log();
  return x;
}

std::array<double, kHumpFeatures> hump_features_of(const Input& input) {
  return first_of(hump_features_of(lanes_of(input)));
}

std::size_t n_weights(int n_inputs, const std::vector<int>& hidden) {
  int n = 0, width = n_inputs;
  for (const int units : hidden) {
    n += units * (width + 1);
    width = units;
  }
  return static_cast<std::size_t>(n + width + 1);
}

HumpNetwork::HumpNetwork(HumpParameters parameters) : parameters_(std::move(parameters)) {
  const HumpParameters& p = parameters_;
  BRASH_EXPECTS(!p.hidden.empty());
  for (const int units : p.hidden) BRASH_EXPECTS(units > 0 && units <= kMostUnits, units);
  for (const auto* networks : {&p.stress, &p.place}) {
    for (const LayeredNetwork& network : *networks) {
      BRASH_EXPECTS(network.weights.size() == n_weights(kHumpFeatures, p.hidden), network.weights.size());
      BRASH_EXPECTS(finite(network.weights));
      expect_valid(network.target);
    }
  }
  for (const Normalisation& n : p.features) expect_valid(n);
  expect_valid(p.range);
  BRASH_EXPECTS(p.thickness_over_lc > 0.0, p.thickness_over_lc);
}

void HumpNetwork::predict(std::span<const Input> inputs, std::span<Output> outputs) const {
  by_lanes(inputs, outputs, [this](const std::array<Lane, kInputs>& x) { return forward(parameters_, x); });
}

}  // namespace brash::meta_model
