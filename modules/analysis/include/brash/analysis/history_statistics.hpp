// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "brash/analysis/load_history.hpp"
#include "brash/analysis/tables.hpp"
#include "brash/statistics/extreme_analysis.hpp"
#include "brash/statistics/spectrum.hpp"

namespace brash::analysis {

/// Choices of the estimates; 0 takes the default.
struct StatisticsSettings {
  statistics::ExtremeSettings extremes;
  double segment = 0.0;           ///< of the spectrum [s]; 0: an eighth of the longest piece
  std::vector<double> exponents;  ///< of damage-equivalent loads
  double frequency = 1.0;         ///< of their sinusoid [Hz]
};

/// The note of `run`, `stats` and `compare` on a history whose `long_enough` is false.
inline constexpr const char* kTooShort =
    "shorter than 50 autocorrelation times; the intervals are themselves uncertain";

/// The load events of a history about its mean.
/// @param dead_band  in deviations of the load; absent: from the noise floor.
std::vector<statistics::LoadEvent> events_of(const LoadHistory& load, std::optional<double> dead_band = std::nullopt);

/// The extremes of a history.
statistics::ExtremeAnalysis extremes_of(const LoadHistory& load, const statistics::ExtremeSettings& settings);

/// The interval of the mean; nulls below ten independent samples, as in summary.json.
nlohmann::ordered_json interval_of_mean(const statistics::Summary& summary);

/// Adds all of Summary::visit() to `out`, the interval as interval_of_mean().
void add_summary(const statistics::Summary& summary, nlohmann::ordered_json& out);

/// Whether the larger loads are the lowest ones, as the vertical loads of a cone that bends the ice up are.
bool acts_downwards(const statistics::Summary& s);

/// The line about a history too short for its statistics, `name` for its subject; "" for one that is long enough.
/// @param side  with the keys of statistics_of().
std::string short_note(const char* name, const nlohmann::ordered_json& side);

/// Statistics of a load history, in the unit of the file; keys as in summary.json where both have them.
nlohmann::ordered_json statistics_of(const LoadHistory& history, const StatisticsSettings& settings = {});

/// The same as text for a reader.
std::string statistics_text(const nlohmann::ordered_json& statistics);

/// Welch's spectrum over segments of `segment` [s], 0 for an eighth of the longest piece, shortened to a length that
/// transforms fast (no prime factor above 5); nothing when that is fewer than 16 samples.
std::optional<statistics::Spectrum> spectrum_of(const LoadHistory& history, double segment);

/// Adds the extremes to the statistics of a history or of pooled ones: `extremes` (Pareto), `block_maxima` (Gumbel),
/// `laws` (all five, with levels, intervals and tests), `recommended` with its reason, `warnings`.
void add_extremes(const statistics::ExtremeAnalysis& analysis, nlohmann::ordered_json& out);

/// "[1, 2]" for the ends of an interval, over `one`; "[1, no upper end]".
std::string ends_text(const nlohmann::ordered_json& ends, double one = 1.0);

/// The extremes as text for a reader.
std::string extremes_text(const nlohmann::ordered_json& statistics);

/// Damage-equivalent loads of histories of one process, pooled, for each exponent of an S-N curve; with 95 % intervals.
///
/// @param stretch    independent stretches are at least so long [s].
/// @param frequency  of the equivalent sinusoid [Hz].
nlohmann::ordered_json fatigue_json(const std::vector<const LoadHistory*>& loads, const std::vector<double>& exponents,
                                    double stretch, double frequency);

/// The same as text for a reader, in `unit`; "" for an empty array.
std::string fatigue_text(const nlohmann::ordered_json& fatigue, const TableUnit& unit = {1.0, ""});

/// A table for a CSV file: its names, and its lines.
struct CsvTable {
  std::string names;  ///< "a,b\n"
  std::string lines;
};

/// Load events, one line each: start, end, peak_time, peak, impulse, rise, fall; for the history of a run also the
/// cause with the largest share of the peak, and the crack nearest to the peak.
///
/// The causes are the columns of the file whose names end in `_COLUMN`, such as crushing_Fx. The cracks are the breaks
/// in the events.csv beside it.
/// @param dead_band  in deviations of the load; absent: from the noise floor.
CsvTable events_table(const LoadHistory& load, std::optional<double> dead_band);

/// How long and how often the load is above fifty levels: level, time_above [s], share, events_above.
CsvTable exceedance_table(const LoadHistory& load, std::optional<double> dead_band);

/// Rainflow cycles: range, mean, count, end [s].
CsvTable cycles_table(const LoadHistory& load);

/// Welch's spectrum with its 95 % band: frequency, density, lower_95, upper_95.
/// @throws InputError when the history or the segment is shorter than 16 samples.
CsvTable spectrum_table(const LoadHistory& load, double segment);

}  // namespace brash::analysis
