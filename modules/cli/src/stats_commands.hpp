// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "brash/io/case.hpp"
#include "brash/statistics/spectrum.hpp"
#include "load_history.hpp"

namespace brash::cli {

/// How to estimate what has a choice; 0 takes the default.
struct StatisticsSettings {
  double return_period = 3600.0;    ///< of extreme levels [s]
  double block = 0.0;               ///< of block maxima [s]; 0: twenty autocorrelation times
  double segment = 0.0;             ///< of the spectrum [s]; 0: an eighth of the longest piece
  std::optional<double> threshold;  ///< of peaks over a threshold; absent: the 90 % quantile
};

/// What `run`, `stats` and `compare` say of a history whose `long_enough` is false.
inline constexpr const char* kTooShort =
    "shorter than 50 autocorrelation times; the intervals are themselves uncertain";

/// Statistics of a load history, in the unit of the file; keys as in summary.json where both have them.
nlohmann::ordered_json statistics_of(const LoadHistory& history, const StatisticsSettings& settings = {});

/// Welch's spectrum over segments of `segment` [s], 0 for an eighth of the longest piece, shortened to a length that
/// transforms fast (no prime factor above 5); nothing when that is fewer than 16 samples.
std::optional<statistics::Spectrum> spectrum_of(const LoadHistory& history, double segment);

/// The same, and closed-form loads, as text for a reader.
std::string statistics_text(const nlohmann::ordered_json& statistics);
std::string loads_text(const nlohmann::ordered_json& loads);

/// `brash stats FILE`; callbacks throw InputError.
void add_stats_command(CLI::App& app);
/// `brash compare RUN MEASURED`; callbacks throw InputError.
void add_compare_command(CLI::App& app);
/// `brash trend CAMPAIGN --along KEY`; callbacks throw InputError.
void add_trend_command(CLI::App& app);
/// `brash loads CASE.toml`
void add_loads_command(CLI::App& app);

}  // namespace brash::cli
