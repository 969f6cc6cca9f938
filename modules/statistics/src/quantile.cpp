// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/quantile.hpp"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>

namespace brash::statistics {

std::vector<double> quantiles(std::vector<double> values, std::span<const double> levels) {
  if (values.empty()) return {};
  std::ranges::sort(values);
  std::vector<double> result;
  for (const double level : levels)
    result.push_back(gsl_stats_quantile_from_sorted_data(values.data(), 1, values.size(), level));
  return result;
}

}  // namespace brash::statistics
