// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/quantile.hpp"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <utility>

#include "brash/core/contract.hpp"

namespace brash::statistics {
namespace {

/// Quantiles of n sorted values with the distance from each to the one before.
template <class Value, class Distance>
std::vector<double> quantiles_along(std::size_t n, Value value, Distance distance, std::span<const double> levels) {
  double length = 0.0;
  for (std::size_t i = 1; i < n; ++i) length += distance(i);
  std::vector<double> result;
  for (const double level : levels) {
    const double wanted = level * length;
    double before = 0.0, reached = 0.0;
    std::size_t i = 0;
    while (reached <= wanted && ++i < n) {
      before = reached;
      reached += distance(i);
    }
    if (i == n) {
      result.push_back(value(n - 1));
      continue;
    }
    const double share = (wanted - before) / (reached - before);
    result.push_back(value(i - 1) + share * (value(i) - value(i - 1)));
  }
  return result;
}

std::vector<std::pair<double, double>> sorted_pairs(std::span<const double> values, std::span<const double> weights) {
  std::vector<std::pair<double, double>> sorted(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) sorted[i] = {values[i], weights[i]};
  std::ranges::sort(sorted);
  return sorted;
}

}  // namespace

std::vector<double> quantiles(std::vector<double> values, std::span<const double> levels) {
  if (values.empty()) return {};
  std::ranges::sort(values);
  std::vector<double> result;
  for (const double level : levels)
    result.push_back(gsl_stats_quantile_from_sorted_data(values.data(), 1, values.size(), level));
  return result;
}

std::vector<double> quantiles(std::span<const double> values, std::span<const double> weights,
                              std::span<const double> levels) {
  BRASH_EXPECTS(weights.size() == values.size() || weights.size() == 1, values.size(), weights.size());
  if (values.empty()) return {};
  if (weights.size() == 1) {
    std::vector<double> sorted(values.begin(), values.end());
    std::ranges::sort(sorted);
    const double step = 0.5 * (weights[0] + weights[0]);
    return quantiles_along(
        sorted.size(), [&](std::size_t i) { return sorted[i]; }, [=](std::size_t) { return step; }, levels);
  }
  const auto sorted = sorted_pairs(values, weights);
  return quantiles_along(
      sorted.size(), [&](std::size_t i) { return sorted[i].first; },
      [&](std::size_t i) { return 0.5 * (sorted[i - 1].second + sorted[i].second); }, levels);
}

std::vector<double> quantiles_of_shares(std::span<const double> values, std::span<const double> weights,
                                        std::span<const double> levels) {
  BRASH_EXPECTS(!values.empty() && weights.size() == values.size(), values.size(), weights.size());
  constexpr double kRounding = 1e-12;  // relative, of a sum of weights that should be the level
  const auto sorted = sorted_pairs(values, weights);
  double whole = 0.0;
  for (const auto& [value, weight] : sorted) whole += weight;
  std::vector<double> result;
  for (const double level : levels) {
    std::size_t i = 0;
    for (double sum = sorted[0].second; i + 1 < sorted.size() && sum < level * whole * (1.0 - kRounding);)
      sum += sorted[++i].second;
    result.push_back(sorted[i].first);
  }
  return result;
}

}  // namespace brash::statistics
