// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "brash/statistics/extremes.hpp"
#include "brash/statistics/hypothesis.hpp"

namespace brash::statistics {

/// Distributions of the sizes of floes; docs/theory/ice.md.
enum class SizeLaw {
  kLogNormal,  ///< parameters: median, deviation of the natural logarithm
  kWeibull,    ///< parameters: scale, shape
  kPowerTail,  ///< parameters: the least size of the tail, exponent of the density
};

/// "log-normal", "Weibull", "power law of the tail".
const char* name_of(SizeLaw law);

/// A distribution that was fitted to sizes.
struct SizeFit {
  SizeLaw law = SizeLaw::kLogNormal;
  /// A size: the median, the scale, or the least size of the tail; unit of the sizes.
  Estimate scale;
  /// The deviation of ln(size), Weibull's shape, or the exponent of the density, > 1 [-].
  Estimate shape;
  std::size_t n = 0;  ///< sizes it was fitted to: all, or the sizes of the tail
  /// Anderson and Darling's test, or Kolmogorov and Smirnov's of the tail.
  TestResult goodness;

  /// Probability of a larger size; of the tail: among the sizes of the tail.
  double exceedance(double size) const;
};

/// How a tail is evaluated.
struct TailSettings {
  std::size_t n_resamples = 500;      ///< of the goodness of fit, and of the intervals
  std::size_t most_candidates = 100;  ///< for the least size of the tail, spread evenly over the sorted sizes
  double confidence = 0.95;
};

/// Maximum-likelihood fit with exact intervals (Student's, chi squared) and Anderson and Darling's test for a normal
/// logarithm (Stephens).
/// @param sizes  > 0; at least 10 that are not all equal.
/// @see docs/theory/ice.md, (D2), (D3).
tl::expected<SizeFit, FitError> fit_log_normal_sizes(std::span<const double> sizes, double confidence = 0.95);

/// Maximum-likelihood fit with intervals from the information matrix, on the scale of logarithms.
/// @see docs/theory/ice.md, (D4).
tl::expected<SizeFit, FitError> fit_weibull_sizes(std::span<const double> sizes, double confidence = 0.95);

/// The tail above the least size from which on a power law fits best, after Clauset, Shalizi and Newman.
///
/// The least size minimises Kolmogorov and Smirnov's distance. Intervals are percentiles of the bootstrap, the choice
/// of the least size in it. The p-value counts simulated samples, chosen and fitted in the same way, that lie farther
/// off.
/// @param sizes  > 0; at least 50, of which the tail keeps at least 10.
/// @see A. Clauset, C. R. Shalizi, M. E. J. Newman, SIAM Review 51 (2009) 661; docs/theory/ice.md, (D5), (D6).
tl::expected<SizeFit, FitError> fit_power_tail(std::span<const double> sizes, const TailSettings& settings = {});

}  // namespace brash::statistics
