// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/quantile.hpp"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <utility>

#include "brash/core/contract.hpp"

namespace brash::statistics {

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
  BRASH_EXPECTS(values.size() == weights.size(), values.size(), weights.size());
  if (values.empty()) return {};
  std::vector<std::pair<double, double>> sorted(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) sorted[i] = {values[i], weights[i]};
  std::ranges::sort(sorted);
  std::vector<double> reached(sorted.size(), 0.0);
  for (std::size_t i = 1; i < sorted.size(); ++i)
    reached[i] = reached[i - 1] + 0.5 * (sorted[i - 1].second + sorted[i].second);

  std::vector<double> result;
  for (const double level : levels) {
    const double wanted = level * reached.back();
    const auto above = std::ranges::upper_bound(reached, wanted);
    if (above == reached.end()) {
      result.push_back(sorted.back().first);
      continue;
    }
    const auto i = static_cast<std::size_t>(above - reached.begin());
    const double share = (wanted - reached[i - 1]) / (reached[i] - reached[i - 1]);
    result.push_back(sorted[i - 1].first + share * (sorted[i].first - sorted[i - 1].first));
  }
  return result;
}

}  // namespace brash::statistics
