// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace brash::statistics {

/// An interval at a stated confidence.
struct Interval {
  double lower = 0.0;
  double upper = 0.0;
};

/// A history in pieces between which it is unknown; each evenly sampled, none empty.
using Pieces = std::vector<std::span<const double>>;

/// A statistic of a load history, as files and texts have it.
struct Statistic {
  const char* name;       ///< in files
  const char* unit;       ///< "": that of the load; else of UDUNITS, 1 for ratios and counts
  const char* row;        ///< of a text, in which statistics may share a row; "": it has none of its own
  bool turns = false;     ///< changes its sign with the load
  const char* note = "";  ///< behind its value in a text
  bool in_runs = true;    ///< the summary of a run has it
};

/// Statistics of one evenly sampled load history.
struct Summary {
  std::size_t n = 0;
  double mean = 0.0;
  double standard_deviation = 0.0;  ///< with n - 1
  double minimum = 0.0;
  double maximum = 0.0;
  double skewness = 0.0;         ///< m3 / m2^1.5 of central moments with n; 0 for a constant history
  double excess_kurtosis = 0.0;  ///< m4 / m2^2 - 3
  double quantile_1 = 0.0;       ///< the end of the larger loads where they are negative
  double quantile_50 = 0.0;
  double quantile_95 = 0.0;
  double quantile_99 = 0.0;
  double autocorrelation_time = 0.0;   ///< integrated [s], of a load with its slow changes; dt/2 for white noise
  double effective_sample_size = 0.0;  ///< n dt / (2 tau), in [1, n]
  Interval mean_95;                    ///< 95 % confidence interval of the mean
  /// The history is at least 50 autocorrelation times long; below that tau and the interval are themselves uncertain.
  bool long_enough = false;

  /// Calls `visit(statistic, member)` for each but `n`. This one list serves summary.json, the columns of campaigns and
  /// their units, `brash stats` and `compare`, reports and Python.
  template <typename Visit>
  static void visit(Visit&& visit) {
    constexpr bool kTurns = true;
    const auto level = [](const char* name, const char* row) { return Statistic{name, "", row, kTurns}; };
    visit(level("mean", "mean"), &Summary::mean);
    visit(level("mean_95", "mean"), &Summary::mean_95);
    visit(Statistic{"standard_deviation", "", "standard deviation"}, &Summary::standard_deviation);
    visit(level("minimum", "minimum, maximum"), &Summary::minimum);
    visit(level("maximum", "minimum, maximum"), &Summary::maximum);
    visit(Statistic{"skewness", "1", "skewness, kurtosis", kTurns}, &Summary::skewness);
    visit(Statistic{"excess_kurtosis", "1", "skewness, kurtosis", false, " (excess)", false},
          &Summary::excess_kurtosis);
    visit(level("quantile_1", "1, 50, 95, 99 %"), &Summary::quantile_1);
    visit(level("quantile_50", "1, 50, 95, 99 %"), &Summary::quantile_50);
    visit(level("quantile_95", "1, 50, 95, 99 %"), &Summary::quantile_95);
    visit(level("quantile_99", "1, 50, 95, 99 %"), &Summary::quantile_99);
    visit(Statistic{"autocorrelation_time", "s", ""}, &Summary::autocorrelation_time);
    visit(Statistic{"effective_sample_size", "1", ""}, &Summary::effective_sample_size);
    visit(Statistic{"long_enough", "1", ""}, &Summary::long_enough);
  }
};

/// Integrated autocorrelation time and how it was found.
struct AutocorrelationTime {
  double tau = 0.0;        ///< [s]
  std::size_t window = 0;  ///< lags summed
  bool converged = false;  ///< the automatic window closed before half of the history
};

/// Summary of a stationary history.
///
/// Quantiles interpolate linearly between order statistics (Hyndman and Fan's type 7). The interval of the mean is
/// Student's with n_eff - 1 degrees of freedom and the standard error s / sqrt(n_eff).
///
/// @param samples  load history [N], shape=(n,), n >= 2, finite, evenly sampled every `dt` [s].
/// @see docs/theory/statistics.md, (S3), (S17).
Summary summarise(std::span<const double> samples, double dt);

/// Autocorrelations rho_0 = 1, rho_1, ... of the samples about their mean, normalised by n; shape=(max_lag + 1,).
/// A constant history has rho_k = 0 for k > 0.
std::vector<double> autocorrelation(std::span<const double> samples, std::size_t max_lag);

/// The same of a history in pieces, about the mean of all. Products do not straddle pieces; the mean product of the
/// pairs at lag k is multiplied by (n - k)/n, so that one piece gives the estimate above.
///
/// @param max_lag  less than the length of the longest piece.
std::vector<double> autocorrelation(const Pieces& pieces, std::size_t max_lag);

/// Integrated autocorrelation time with Sokal's automatic window: the first W with W >= 5 tau(W) / dt, and Wolff's
/// correction for the mean being estimated from the same samples.
///
/// tau = dt (1/2 + sum_{k=1}^{W} rho_k) (1 + (2 W + 1) / n), at least dt/2; docs/theory/statistics.md, (S2).
///
/// @see A. Sokal, Monte Carlo methods in statistical mechanics, 1997; U. Wolff, Comput. Phys. Commun. 156 (2004) 143.
AutocorrelationTime autocorrelation_time(std::span<const double> samples, double dt);
AutocorrelationTime autocorrelation_time(const Pieces& pieces, double dt);

}  // namespace brash::statistics
