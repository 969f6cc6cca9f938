// SPDX-License-Identifier: GPL-3.0-or-later
#include "network_errors.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"

namespace brash::training {

using namespace meta_model;

namespace {

double root_mean_square(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace

double quantile(std::span<const double> sorted, double share) {
  BRASH_EXPECTS(!sorted.empty() && share >= 0.0 && share <= 1.0, sorted.size(), share);
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

Errors errors(const Network& network, std::span<const Sample> samples) {
  Errors result;
  if (samples.empty()) return result;
  std::vector<double> stress, absolute, length;
  std::set<int> geometries;
  double bias = 0.0, on_plateau = 0.0;
  for (const Sample& s : samples) {
    const Output predicted = network.predict(s.input);
    const double stress_error = predicted.sigma_over_p / s.output.sigma_over_p - 1.0;
    bias += stress_error;
    stress.push_back(std::abs(stress_error));
    absolute.push_back(std::abs(predicted.sigma_over_p - s.output.sigma_over_p));
    length.push_back(std::abs(predicted.lbreak_over_lc - s.output.lbreak_over_lc));
    on_plateau += predicted.lbreak_over_lc >= s.plateau_from && predicted.lbreak_over_lc <= s.plateau_to ? 1.0 : 0.0;
    geometries.insert(s.geometry);
  }
  std::sort(stress.begin(), stress.end());
  std::sort(absolute.begin(), absolute.end());
  std::sort(length.begin(), length.end());
  const auto n = static_cast<double>(samples.size());
  constexpr double kHigh = 0.95;
  return {.n_rows = samples.size(),
          .n_geometries = geometries.size(),
          .stress_bias = bias / n,
          .stress_rms = root_mean_square(stress),
          .stress_median = quantile(stress, 0.5),
          .stress_95 = quantile(stress, kHigh),
          .stress_max = stress.back(),
          .stress_absolute_95 = quantile(absolute, kHigh),
          .length_rms = root_mean_square(length),
          .length_median = quantile(length, 0.5),
          .length_95 = quantile(length, kHigh),
          .length_on_plateau = on_plateau / n};
}

std::vector<Region> errors_by_region(const Network& network, const std::vector<Sample>& samples) {
  using Part = bool (*)(const Input&, const Output&);
  static constexpr std::array<std::pair<const char*, Part>, 16> kParts{{
      {"b < 0 (bay)", [](const Input& x, const Output&) { return x.b_lc < 0.0; }},
      {"b < 0.25 l_c", [](const Input& x, const Output&) { return x.b_lc >= 0.0 && x.b_lc < 0.25; }},
      {"0.25 l_c <= b < l_c", [](const Input& x, const Output&) { return x.b_lc >= 0.25 && x.b_lc < 1.0; }},
      {"b >= l_c", [](const Input& x, const Output&) { return x.b_lc >= 1.0; }},
      {"c < 0.1 l_c", [](const Input& x, const Output&) { return x.c_lc < 0.1; }},
      {"0.1 l_c <= c < 0.5 l_c", [](const Input& x, const Output&) { return x.c_lc >= 0.1 && x.c_lc < 0.5; }},
      {"c >= 0.5 l_c", [](const Input& x, const Output&) { return x.c_lc >= 0.5; }},
      {"theta < 45 deg", [](const Input& x, const Output&) { return x.theta < radians(45.0); }},
      {"45 deg <= theta < 90 deg",
       [](const Input& x, const Output&) { return x.theta >= radians(45.0) && x.theta < radians(90.0); }},
      {"theta >= 90 deg", [](const Input& x, const Output&) { return x.theta >= radians(90.0); }},
      {"mu1 < 0.3", [](const Input& x, const Output&) { return x.mu1 < 0.3; }},
      {"0.3 <= mu1 < 1", [](const Input& x, const Output&) { return x.mu1 >= 0.3 && x.mu1 < 1.0; }},
      {"mu1 >= 1", [](const Input& x, const Output&) { return x.mu1 >= 1.0; }},
      {"sigma/p < 0.25 (crushed first)", [](const Input&, const Output& y) { return y.sigma_over_p < 0.25; }},
      {"sigma/p >= 0.25", [](const Input&, const Output& y) { return y.sigma_over_p >= 0.25; }},
      {"sigma/p >= 0.25 and 0.3 <= mu1 < 1",
       [](const Input& x, const Output& y) { return y.sigma_over_p >= 0.25 && x.mu1 >= 0.3 && x.mu1 < 1.0; }},
  }};
  std::vector<Region> regions;
  for (const auto& [name, holds] : kParts) {
    std::vector<Sample> part;
    std::copy_if(samples.begin(), samples.end(), std::back_inserter(part),
                 [&holds = holds](const Sample& s) { return holds(s.input, s.output); });
    if (!part.empty()) regions.push_back({name, errors(network, part)});
  }
  return regions;
}

}  // namespace brash::training
