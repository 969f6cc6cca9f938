// SPDX-License-Identifier: GPL-3.0-or-later
// The model files of the networks: JSON with everything that they need, and its own hash.
#include <algorithm>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/meta_model/features.hpp"
#include "brash/meta_model/network.hpp"
#include "json_file.hpp"

namespace brash::meta_model {
namespace {

constexpr int kNetworkVersion = 1;
constexpr int kHumpVersion = 1;

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

Json to_json(const Range& range) {
  Json inputs = Json::array();
  const auto lower = to_array(range.lower), upper = to_array(range.upper);
  for (int i = 0; i < kInputs; ++i) {
    inputs.push_back({{"name", kInputNames[i]}, {"unit", kInputUnits[i]}, {"lower", lower[i]}, {"upper", upper[i]}});
  }
  return inputs;
}

Json to_json(const NetworkParameters& p) {
  Json model{{"equation", "y = W2 S(W1 X + b1) + b2; S(a) = 1/(1 + exp(-a)); X, y: (value - offset)/factor"},
             {"inputs", to_json(p.range)},
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

constexpr std::array<const char*, kHumpFeatures> hump_feature_names() {
  std::array<const char*, kHumpFeatures> names{};
  std::copy(kFeatureNames.begin(), kFeatureNames.end(), names.begin());
  names.back() = kContactFeature;
  return names;
}

Json to_json(const HumpParameters& p) {
  Json networks = Json::array();
  for (std::size_t hump = 0; hump < kHumps; ++hump) {
    for (const auto& [target, network] :
         {std::pair{kHumpTargets[0], &p.stress[hump]}, {kHumpTargets[1], &p.place[hump]}}) {
      networks.push_back({{"hump", kHumpNames[hump]},
                          {"value", target},
                          {"offset", network->target.offset},
                          {"factor", network->target.factor},
                          {"weights", network->weights}});
    }
  }
  return {{"equation",
           "y = W_n S(... S(W_1 X + b_1) ...) + b_n; S(a) = 1/(1 + exp(-a)); X, y: (value - offset)/factor; the hump "
           "with the larger stress answers; weights: layer by layer, W row by row and then b"},
          {"inputs", to_json(p.range)},
          {"features", to_json(hump_feature_names(), p.features)},
          {"hidden", p.hidden},
          {"networks", networks},
          {"thickness_over_lc", p.thickness_over_lc},
          {"data_sha256", p.data_sha256}};
}

LayeredNetwork read_layered(const Place& place, const char* hump, const char* target, std::size_t n) {
  place["hump"].expect_text(hump);
  place["value"].expect_text(target);
  return {{place["offset"].number(), place["factor"].positive()}, place["weights"].numbers(n)};
}

HumpParameters to_hump_parameters(const Place& place) {
  HumpParameters p;
  read_range(place["inputs"], p.range);
  read_normalisations(place["features"], hump_feature_names(), p.features);
  const Place hidden = place["hidden"];
  for (const double units : hidden.numbers(hidden.size())) {
    if (!(units >= 1.0 && units <= kMostUnits && units == std::floor(units))) {
      hidden.refuse(fmt::format("must be a list of whole numbers in [1, {}]", kMostUnits));
    }
    p.hidden.push_back(static_cast<int>(units));
  }
  if (p.hidden.empty()) hidden.refuse("must not be empty");
  const std::size_t n = n_weights(kHumpFeatures, p.hidden);
  const Place networks = place["networks"];
  networks.expect_size(2 * kHumps);
  for (std::size_t hump = 0; hump < kHumps; ++hump) {
    p.stress[hump] = read_layered(networks[2 * hump], kHumpNames[hump], kHumpTargets[0], n);
    p.place[hump] = read_layered(networks[2 * hump + 1], kHumpNames[hump], kHumpTargets[1], n);
  }
  p.thickness_over_lc = place["thickness_over_lc"].positive();
  p.data_sha256 = place["data_sha256"].text();
  return p;
}

/// Refuses weights whose answers at the corners and in the middle of the range are no stresses and lengths.
template <typename Model>
Model expect_ordinary(const Place& place, Model model) {
  constexpr double kMostStress = 1e6, kMostLength = 1e3;  // over p and l_c; trained models stay below 1e2 and 1e1
  const auto lower = to_array(model.range().lower), upper = to_array(model.range().upper);
  for (int corner = 0; corner <= 1 << kInputs; ++corner) {
    auto x = lower;
    for (int i = 0; i < kInputs; ++i)
      x[i] = corner == 1 << kInputs ? 0.5 * (lower[i] + upper[i]) : (corner >> i & 1) != 0 ? upper[i] : lower[i];
    const Output y = model.predict(to_input(x));
    if (std::abs(y.sigma_over_p) <= kMostStress && std::abs(y.lbreak_over_lc) <= kMostLength) continue;
    place.refuse(
        fmt::format("its weights are absurd: within its range they give sigma/p = {:.3g}, l_break/l_c = {:.3g}",
                    y.sigma_over_p, y.lbreak_over_lc));
  }
  return model;
}

}  // namespace

std::unique_ptr<ResponseNetwork> read_network(const std::string& path) {
  if (model_format(path) == kHumpFormat) return std::make_unique<HumpNetwork>(HumpNetwork::read(path));
  return std::make_unique<Network>(Network::read(path));
}

HumpNetwork HumpNetwork::read(const std::string& path) {
  const Json model = read_model(path, kHumpFormat, kHumpVersion);
  const Place place(path, model, "");
  return expect_ordinary(place, HumpNetwork(to_hump_parameters(place)));
}

std::string HumpNetwork::write(const std::string& path) const {
  return write_model(path, kHumpFormat, kHumpVersion, to_json(parameters_), -1);
}

Network Network::read(const std::string& path) {
  const Json model = read_model(path, kNetworkFormat, kNetworkVersion);
  const Place place(path, model, "");
  return expect_ordinary(place, Network(to_parameters(place)));
}

std::string Network::write(const std::string& path) const {
  return write_model(path, kNetworkFormat, kNetworkVersion, to_json(parameters_), 1);
}

}  // namespace brash::meta_model
