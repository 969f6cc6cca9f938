// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace brash::statistics {

/// Moments of a sample; docs/theory/statistics.md, (S1).
struct Moments {
  std::size_t n = 0;
  double mean = 0.0;
  double variance = 0.0;         ///< with n - 1
  double skewness = 0.0;         ///< m3 / m2^1.5, central moments with n; 0 when all values are equal
  double excess_kurtosis = 0.0;  ///< m4 / m2^2 - 3; 0 when all values are equal
  double minimum = 0.0;
  double maximum = 0.0;
};

/// @param samples  shape=(n,), n >= 2, finite.
Moments moments(std::span<const double> samples);

/// Moments of samples that represent different times: sums over samples become weighted ones, and the variance keeps
/// its factor n/(n - 1). Equal weights give the moments above.
///
/// @param weights  shape=(n,), or (1,) when all are equal; > 0.
Moments moments(std::span<const double> samples, std::span<const double> weights);

/// Counts in bins of equal width.
struct Histogram {
  std::vector<double> edges;        ///< shape=(n_bins + 1,)
  std::vector<std::size_t> counts;  ///< shape=(n_bins,)
  std::size_t n_outside = 0;
};

/// Counts samples in `n_bins` bins over [lower, upper]. A bin holds its lower edge; the last one holds its upper edge
/// too.
///
/// @param lower, upper  lower < upper.
Histogram histogram(std::span<const double> samples, std::size_t n_bins, double lower, double upper);

}  // namespace brash::statistics
