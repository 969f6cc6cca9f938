// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <tl/expected.hpp>
#include <vector>

#include "brash/statistics/extremes.hpp"
#include "brash/statistics/hypothesis.hpp"

namespace brash::statistics {

/// The peaks of one state of the ice over a threshold, by record.
struct StatePeaks {
  double threshold = 0.0;                 ///< u, unit of the load
  std::vector<std::vector<double>> over;  ///< independent peaks > u of each record
  std::vector<double> durations;          ///< of the records [s]

  double duration() const;  ///< of all records [s]
};

/// A load that is exceeded `expected` times on average in `seconds` of each state; shape=(n_states,).
struct Exposure {
  std::vector<double> seconds;
  double expected = 1.0;
};

/// Pareto's law of the peaks of several states of the ice, with one shape for all of them.
///
/// Each state has its own threshold, scale and rate of peaks. A few dozen peaks do not show the shape of a tail; those
/// of all states together do. docs/theory/statistics.md, (S14), and its intervals, docs/theory/statistics.md, (S18).
class SharedTail {
 public:
  /// Fewest peaks of a state, for its scale.
  static constexpr std::size_t kFewestOfState = 3;
  /// Fewest peaks of all states together, for their shape.
  static constexpr std::size_t kFewestPeaks = 20;

  /// Maximum likelihood, with a shape in [-0.5, 1].
  /// @param states  each with kFewestOfState peaks at least.
  static tl::expected<SharedTail, FitError> fit(std::vector<StatePeaks> states);

  double shape() const { return best_.shape; }
  Interval shape_interval(double confidence = 0.95) const;
  double scale(std::size_t state) const { return best_.scales[state].scale; }
  std::size_t n_states() const { return states_.size(); }
  std::size_t n_peaks() const;
  /// Variance of the shape over resampled records, over that of independent peaks; at least 1. Intervals allow so much
  /// more deviance (Chandler and Bate 2007). 1 where a state has a single record.
  double dispersion() const { return dispersion_; }
  /// Likelihood ratio test of one shape against one for each state: chi squared; p = 1 for a single state.
  TestResult one_shape() const;

  /// Exceedances of level x in an exposure, by state.
  std::vector<double> shares(double x, const std::vector<double>& seconds) const;
  /// The level of an exposure with its interval: nothing when a peak over the thresholds is not expected often enough.
  ///
  /// The interval is the profile likelihood's over the shape, widened by dispersion(); at each shape the errors of
  /// scales and rates add by first order.
  std::optional<Estimate> level(const Exposure& asked, double confidence = 0.95) const;

 private:
  /// The best scale of a state at a given shape.
  struct Scale {
    double scale = 1.0, log_likelihood = 0.0;
    double variance = 0.0;  ///< of ln(scale) [-]
  };
  /// All states at one shape.
  struct AtShape {
    double shape = 0.0, log_likelihood = 0.0;
    std::vector<Scale> scales;
  };

  static Scale best_scale(const std::vector<double>& excesses, double shape);
  static AtShape at_shape(const std::vector<std::vector<double>>& excesses, double shape);
  static AtShape best_shape(const std::vector<std::vector<double>>& excesses);
  std::optional<double> level_at(const AtShape& at, const std::vector<double>& peaks, double expected) const;
  std::vector<double> shares_at(const AtShape& at, const std::vector<double>& peaks, double x) const;
  double moved(const AtShape& at, const std::vector<double>& peaks, double x, double deviations) const;
  /// Peaks over the thresholds that are expected in so many seconds of each state.
  std::vector<double> peaks_in(const std::vector<double>& seconds) const;
  double allowed(double confidence) const;
  double deviance(const AtShape& at) const;
  double find_dispersion() const;

  std::vector<StatePeaks> states_;
  std::vector<std::vector<double>> excesses_;  // of all records of a state
  AtShape best_;
  std::vector<AtShape> profile_;  // over shapes
  double dispersion_ = 1.0;
};

}  // namespace brash::statistics
