// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "brash/statistics/random.hpp"
#include "brash/statistics/summary.hpp"

namespace brash::statistics {

/// Confidence interval of the mean from the means of `n_batches` batches of equal length (a remainder at the start is
/// left out): Student's with n_batches - 1 degrees of freedom. Valid when a batch is much longer than the
/// autocorrelation time.
///
/// @param n_batches   at least 2, at most n.
/// @param confidence  in (0, 1).
Interval batch_means_interval(std::span<const double> samples, std::size_t n_batches, double confidence = 0.95);

/// Student's interval of the mean of independent values, such as the means of replicates; n >= 2.
Interval mean_interval(std::span<const double> independent, double confidence = 0.95);

/// How many values make the interval of their mean at most half as wide as `n` values do, if they differ as much; n
/// >= 2.
std::size_t values_for_half_interval(std::size_t n, double confidence = 0.95);

/// Length of bootstrap blocks for a first-order process of this autocorrelation time: the length that minimises the
/// error of the variance of the mean, L = (3/2 (tau - 1/(4 tau))^2 n)^(1/3), tau in samples; 1 for white noise.
///
/// @see D. N. Politis, H. White, Econometric Reviews 23 (2004) 53; docs/theory/statistics.md, (S4).
std::size_t block_length(double tau_in_samples, std::size_t n);

/// How to bootstrap.
struct BootstrapSettings {
  std::size_t block_length = 1;  ///< [samples]; 1 for independent values
  std::size_t n_resamples = 1000;
  double confidence = 0.95;
};

/// Interval of any statistic from the circular block bootstrap, which keeps the correlation inside blocks. Each draw is
/// compared with its own error, from a jackknife over at most 40 groups of blocks (bootstrap-t). A statistic that is
/// positive in every draw is taken on its logarithm. docs/theory/statistics.md, (S16).
///
/// @param statistic  of a history up to as long as `samples`; called up to 41 (n_resamples + 1) times.
/// @param stream     draws the blocks; the result repeats with the stream's key.
/// @see D. N. Politis, J. P. Romano, 1992; B. Efron, R. J. Tibshirani, 1993.
Interval bootstrap_interval(std::span<const double> samples,
                            const std::function<double(std::span<const double>)>& statistic,
                            const BootstrapSettings& settings, RandomStream& stream);

}  // namespace brash::statistics
