// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace brash::statistics {

/// An interval at a stated confidence.
struct Interval {
  double lower = 0.0;
  double upper = 0.0;
};

/// Statistics of one evenly sampled load history.
struct Summary {
  std::size_t n = 0;
  double mean = 0.0;
  double standard_deviation = 0.0;
  double minimum = 0.0;
  double maximum = 0.0;
  double skewness = 0.0;
  double quantile_50 = 0.0;
  double quantile_95 = 0.0;
  double quantile_99 = 0.0;
  double autocorrelation_time = 0.0;   ///< integrated [s]
  double effective_sample_size = 0.0;  ///< n dt / (2 tau) style, see docs/theory/statistics.md
  Interval mean_95;                    ///< 95 % confidence interval of the mean
};

/// @param samples  load history [N], shape=(n,), evenly sampled every `dt` [s].
Summary summarise(std::span<const double> samples, double dt);

}  // namespace brash::statistics
