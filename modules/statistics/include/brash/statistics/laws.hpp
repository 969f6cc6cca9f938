// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "brash/statistics/extremes.hpp"
#include "brash/statistics/hypothesis.hpp"

namespace brash::statistics {

/// Distributions of extreme loads: of block maxima (Gumbel, GEV), of the peaks over a threshold (Pareto), of all peaks
/// over a level (Weibull, Rayleigh).
enum class Law { kGumbel, kGev, kPareto, kWeibull, kRayleigh };

/// "Gumbel", "GEV", "Pareto", "Weibull", "Rayleigh".
const char* name_of(Law law);
/// Whether the law is of block maxima; else of peaks.
bool is_of_blocks(Law law);

/// One distribution of extremes; docs/theory/statistics.md, (S9).
struct Distribution {
  Law law = Law::kGumbel;
  double location = 0.0;  ///< mode (Gumbel, GEV), threshold (Pareto), level (Weibull, Rayleigh); unit of the load
  double scale = 1.0;     ///< > 0, unit of the load
  double shape = 0.0;     ///< xi of GEV and Pareto, k of Weibull [-]; 0 for the others

  /// Probability of a larger value.
  double exceedance(double x) const;
  /// Level that one value exceeds with the probability `exceedance`, in (0, 1).
  double level(double exceedance) const;
  /// Logarithm of the density; -infinity outside the support.
  double log_density(double x) const;
};

/// A distribution with the values that it was fitted to.
struct LawFit {
  Distribution distribution;
  std::vector<double> values;  ///< sorted, unit of the load
};

/// Maximum-likelihood fit of `law`.
///
/// @param values  independent: block maxima, or peaks; those at or below `origin` are left out for laws of peaks.
/// @param origin  threshold of Pareto, level of Weibull and Rayleigh; without meaning for block maxima.
/// @return the fit; an error below 10 values (3 for Gumbel), for equal values, or without a regular maximum.
tl::expected<LawFit, FitError> fit_law(Law law, std::span<const double> values, double origin = 0.0);

/// Level that one value exceeds with the probability `exceedance`, with the interval from its profile likelihood.
///
/// The limit of the likelihood ratio is n ln(1 + t^2/(n - p)) with Student's t of n - p degrees of freedom, for n
/// values and p parameters. It tends to chi squared, and is exact for a normal mean with n - 1 in place of n - p. The
/// Poisson error of the number of peaks adds in quadrature to the interval of laws of peaks.
///
/// @param exceedance  in (0, 1).
/// @see docs/theory/statistics.md, (S10).
/// @return an upper end of infinity when the likelihood does not bound the level.
Estimate level_with_interval(const LawFit& fit, double exceedance, double confidence = 0.95);

/// Anderson and Darling's test that values follow the law that was fitted to them.
///
/// The statistic of simulated samples, fitted in the same way, gives p. It depends on the law, its shape and the
/// number of values alone. So samples are simulated once for each law, shape to 0.1 and number up to 100, and kept.
class GoodnessOfFit {
 public:
  /// @see docs/theory/statistics.md, (S11).
  TestResult test(const LawFit& fit);

 private:
  struct Key {
    Law law;
    int shape;  ///< in tenths; 0 for laws whose statistic does not depend on it
    std::size_t n;
    auto operator<=>(const Key&) const = default;
  };
  static std::vector<double> simulate(const Key& key);

  std::map<Key, std::vector<double>> statistics_;  ///< sorted
};

}  // namespace brash::statistics
