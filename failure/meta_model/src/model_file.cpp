// SPDX-License-Identifier: GPL-3.0-or-later
// The model file: JSON with everything that Eq. 17 needs, and its own hash.
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/meta_model/network.hpp"
#include "features.hpp"
#include "json_file.hpp"

namespace brash::meta_model {
namespace {

constexpr int kNetworkVersion = 1;

constexpr std::array<const char*, kInputs> kInputNames{"b_lc", "c_lc", "theta", "mu1", "mu2"};
constexpr std::array<const char*, kInputs> kInputUnits{"1", "1", "rad", "1", "1"};

template <std::size_t N>
Json to_json(const std::array<const char*, N>& names, const std::array<Normalisation, N>& normalisations) {
  Json list = Json::array();
  for (std::size_t i = 0; i < N; ++i) {
    list.push_back({{"value", names[i]}, {"offset", normalisations[i].offset}, {"factor", normalisations[i].factor}});
  }
  return list;
}

Json rows_of(const std::vector<double>& values, int n_columns) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < values.size(); i += n_columns) {
    rows.push_back(std::vector<double>(values.begin() + i, values.begin() + i + n_columns));
  }
  return rows;
}

Json to_json(const NetworkParameters& p) {
  Json inputs = Json::array();
  const auto lower = to_array(p.range.lower), upper = to_array(p.range.upper);
  for (int i = 0; i < kInputs; ++i) {
    inputs.push_back({{"name", kInputNames[i]}, {"unit", kInputUnits[i]}, {"lower", lower[i]}, {"upper", upper[i]}});
  }
  Json model{{"equation", "y = W2 S(W1 X + b1) + b2; S(a) = 1/(1 + exp(-a)); X, y: (value - offset)/factor"},
             {"inputs", inputs},
             {"features", to_json(kFeatureNames, p.features)},
             {"targets", to_json(kTargetNames, p.targets)},
             {"hidden", p.hidden},
             {"W1", rows_of(p.w1, kInputs)},
             {"b1", p.b1},
             {"W2", rows_of(p.w2, p.hidden)},
             {"b2", p.b2},
             {"thickness_over_lc", p.thickness_over_lc},
             {"data_sha256", p.data_sha256}};
  return model;
}

template <std::size_t N>
void read_normalisations(const Place& place, const std::array<const char*, N>& names,
                         std::array<Normalisation, N>& normalisations) {
  place.expect_size(N);
  for (std::size_t i = 0; i < N; ++i) {
    place[i]["value"].expect_text(names[i]);
    normalisations[i] = {place[i]["offset"].number(), place[i]["factor"].positive()};
  }
}

void read_range(const Place& place, Range& range) {
  place.expect_size(kInputs);
  std::array<double, kInputs> lower{}, upper{};
  for (int i = 0; i < kInputs; ++i) {
    const Place input = place[static_cast<std::size_t>(i)];
    input["name"].expect_text(kInputNames[i]);
    input["unit"].expect_text(kInputUnits[i]);
    lower[i] = input["lower"].number();
    upper[i] = input["upper"].number();
    if (lower[i] > upper[i]) input["lower"].refuse("exceeds `upper`");
  }
  range = {to_input(lower), to_input(upper)};
  if (range.lower.b_lc < 0.0) place[std::size_t{0}]["lower"].refuse("must be >= 0");
  if (range.lower.c_lc <= 0.0) place[std::size_t{1}]["lower"].refuse("must be > 0");
  if (range.lower.theta < 0.0) place[std::size_t{2}]["lower"].refuse("must be >= 0");
  if (range.upper.theta >= kPi) place[std::size_t{2}]["upper"].refuse("must be below pi");
  if (range.lower.mu1 <= 0.0) place[std::size_t{3}]["lower"].refuse("must be > 0");
}

NetworkParameters to_parameters(const Place& place) {
  NetworkParameters p;
  read_range(place["inputs"], p.range);
  read_normalisations(place["features"], kFeatureNames, p.features);
  read_normalisations(place["targets"], kTargetNames, p.targets);
  const std::size_t n = place["hidden"].count();
  p.hidden = static_cast<int>(n);
  p.w1 = place["W1"].matrix(n, kInputs);
  p.b1 = place["b1"].numbers(n);
  p.w2 = place["W2"].matrix(kOutputs, n);
  p.b2 = place["b2"].numbers(kOutputs);
  p.thickness_over_lc = place["thickness_over_lc"].positive();
  p.data_sha256 = place["data_sha256"].text();
  return p;
}

}  // namespace

Network Network::read(const std::string& path) {
  const Json model = read_model(path, kNetworkFormat, kNetworkVersion);
  return Network(to_parameters(Place(path, model, "")));
}

std::string Network::write(const std::string& path) const {
  return write_model(path, kNetworkFormat, kNetworkVersion, to_json(parameters_), 1);
}

}  // namespace brash::meta_model
