// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "brash/statistics/extreme_analysis.hpp"
#include "brash/statistics/spectrum.hpp"
#include "load_history.hpp"

namespace brash::cli {

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

}  // namespace brash::cli
