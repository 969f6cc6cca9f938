// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "brash/statistics/summary.hpp"

namespace brash::statistics {

/// Why a distribution could not be fitted.
struct FitError {
  std::string reason;
};

/// A value with its confidence interval.
struct Estimate {
  double value = 0.0;
  Interval interval;
};

/// Gumbel's distribution of maxima, F(x) = exp(-exp(-(x - mu)/beta)).
struct Gumbel {
  double location = 0.0;  ///< mu, unit of the load
  double scale = 0.0;     ///< beta, > 0, unit of the load
  std::size_t n = 0;      ///< maxima it was fitted to
};

/// Maximum-likelihood fit to independent block maxima; at least 3 values that are not all equal.
tl::expected<Gumbel, FitError> fit_gumbel(std::span<const double> maxima);

/// Level exceeded by the maximum of one block in `return_period` (in blocks, > 1) on average.
///
/// x = mu + beta y, y = -ln(-ln(1 - 1/return_period)); the interval is normal with the variance of the asymptotic
/// distribution, (beta^2/n) [1 + 6/pi^2 (1 - gamma + y)^2]; docs/theory/statistics.md, (S5).
Estimate return_level(const Gumbel& fit, double return_period, double confidence = 0.95);

/// Excesses over a threshold, F(y) = 1 - (1 + xi y/sigma)^(-1/xi), 1 - exp(-y/sigma) for xi = 0.
struct GeneralisedPareto {
  double threshold = 0.0;        ///< u, unit of the load
  double scale = 0.0;            ///< sigma, > 0, unit of the load
  double shape = 0.0;            ///< xi [-], > -0.5
  std::vector<double> excesses;  ///< it was fitted to, unit of the load; shape=(n,)
};

/// Maximum-likelihood fit to the independent peaks above `threshold`; at least 10 peaks.
///
/// The likelihood is reduced to one variable (Grimshaw, 1993). Only maxima with xi > -0.5 count, where the likelihood
/// is regular; when there is none, the fit fails; docs/theory/statistics.md, (S6).
tl::expected<GeneralisedPareto, FitError> fit_generalised_pareto(std::span<const double> peaks, double threshold);

/// Level exceeded once in `return_period` [s] on average when the peaks were counted in `duration` [s].
///
/// x = u + (sigma/xi) [(lambda T)^xi - 1], lambda = n/duration; lambda T > 1. The interval comes from the profile
/// likelihood of x, which follows its skewness (a normal interval would cover 82 to 88 % instead of 95 % for 200 peaks
/// and twice the record), with the Poisson error of lambda added in quadrature.
///
/// @throws RunError when the likelihood does not bound the interval.
Estimate return_level(const GeneralisedPareto& fit, double duration, double return_period, double confidence = 0.95);

}  // namespace brash::statistics
