// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "brash/statistics/events.hpp"
#include "brash/statistics/laws.hpp"

namespace brash::statistics {

/// How to look for extremes; 0 and absent take the default.
struct ExtremeSettings {
  double return_period = 3600.0;  ///< [s]
  double block = 0.0;  ///< of block maxima [s]; 0: twenty autocorrelation times and five load cycles at least
  std::optional<double> threshold;  ///< of Pareto's peaks, unit of the load; absent: of the largest tenth, at least 40
  std::optional<double> dead_band;  ///< of load events, in deviations of the load; absent: from the noise floor
  double confidence = 0.95;
  bool extrapolate = false;  ///< gives levels beyond kLongestPeriod records too
};

/// A return period above so many records is marked: the usual limit of extrapolation.
inline constexpr double kMarkedPeriod = 4.0;
/// A return period above so many records gets no level. docs/theory/statistics.md has the coverage there.
inline constexpr double kLongestPeriod = 30.0;
/// Below so many load events a record gets no level by any law.
inline constexpr std::size_t kFewestEvents = 20;

/// Whether a load acts towards its lower end: its mean is negative, and its smallest value is farther from 0 than its
/// largest. With the other sign it has its extremes at the upper end.
bool acts_downwards(double mean, double minimum, double maximum);

/// The warning of a load that acts towards its lower end.
inline constexpr const char* kNegativeMean =
    "the mean is negative, and peaks are of the upper end: negate the history for the larger loads";

/// A history with the statistics that the search for extremes needs.
struct ExtremeRecord {
  const History* history = nullptr;
  const EvenHistory* even = nullptr;
  double autocorrelation_time = 0.0;  ///< [s]
  /// Found before the history was filtered or resampled; absent: it is looked for in `history`.
  std::optional<Clipping> clipping{};
};

/// Peaks and block maxima of one history, or of several replicates of one process.
struct ExtremeValues {
  double duration = 0.0;              ///< of all records [s]
  double mean = 0.0;                  ///< level of the load events, unit of the load
  double dead_band = 0.0;             ///< width, unit of the load
  std::size_t n_events = 0;           ///< load events
  double cycle = 0.0;                 ///< mean time between load events [s]; infinite below two
  double block = 0.0;                 ///< of the maxima [s]
  double shortest_block = 0.0;        ///< stretches as long are about independent [s]
  double threshold = 0.0;             ///< unit of the load
  double separation = 0.0;            ///< peaks over the threshold that are closer are one [s]
  std::vector<double> peaks;          ///< of all load events, shape=(n_events,)
  std::vector<double> over;           ///< of independent load events over the threshold, record after record
  std::vector<std::size_t> over_of;   ///< how many of them each record has, shape=(n_records,)
  std::vector<double> maxima;         ///< of blocks that lie within a record
  std::optional<Clipping> clipping;   ///< of the record whose limit is highest
  double correlation_of_peaks = 0.0;  ///< of successive events [-]
  bool acts_downwards = false;        ///< see acts_downwards()
};

/// Collects the extremes of records of one process. A block never reaches from one record into another.
/// @param records  at least one; the same unit and about the same step.
ExtremeValues extreme_values(const std::vector<ExtremeRecord>& records, const ExtremeSettings& settings);

/// One law with its level, or the reason why there is none.
struct ExtremeEstimate {
  Law law = Law::kGumbel;
  std::optional<LawFit> fit;
  TestResult goodness;            ///< of fit
  double rate = 0.0;              ///< fitted values a second [1/s]
  std::optional<Estimate> level;  ///< of the return period, unit of the load
  std::string refusal;            ///< why there is no fit or no level; else empty
};

/// All laws, the one to use, and the reasons.
struct ExtremeAnalysis {
  ExtremeValues values;
  double return_period = 0.0;                ///< [s]
  std::array<ExtremeEstimate, 5> estimates;  ///< in the order of Law
  std::optional<Law> recommended;
  std::string reason;                 ///< of the recommendation, or why there is none
  std::vector<std::string> warnings;  ///< sentences

  const ExtremeEstimate& of(Law law) const { return estimates[static_cast<std::size_t>(law)]; }
};

/// The warning of peaks that are not independent, in every analysis; "" where successive peaks correlate by 0.3 or
/// less.
std::string correlation_warning(const ExtremeValues& values);

/// Fits each law, tests it, and gives the level that is exceeded once in the return period on average.
///
/// A record that cannot answer the question gets no level. docs/theory/statistics.md has the rules and their coverage.
/// @param goodness  tests the laws; the next call reuses its samples.
ExtremeAnalysis analyse_extremes(ExtremeValues values, const ExtremeSettings& settings, GoodnessOfFit& goodness);

/// The level of one law for a return period [s]; nothing when the period is too short for it.
std::optional<Estimate> level_of(const ExtremeEstimate& estimate, double return_period, double confidence = 0.95);

/// Pareto's fit at one threshold: a threshold is high enough when shape and level no longer change with it.
struct ThresholdFit {
  double threshold = 0.0;
  std::size_t peaks = 0;
  double shape = 0.0;
  Estimate level;
};

/// Fits at up to eight thresholds, from all peaks to the fewest that can be fitted.
std::vector<ThresholdFit> threshold_stability(const ExtremeValues& values, double return_period,
                                              double confidence = 0.95);

}  // namespace brash::statistics
