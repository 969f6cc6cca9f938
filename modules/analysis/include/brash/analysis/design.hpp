// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "brash/analysis/campaign_histories.hpp"
#include "brash/statistics/extreme_analysis.hpp"
#include "brash/statistics/shared_tail.hpp"

namespace brash::analysis {

/// Questions to a campaign.
struct DesignSettings {
  statistics::ExtremeSettings extremes;  ///< of its peaks; the return period is not used
  std::vector<double> hours{1.0};        ///< of exposure: levels that are exceeded once in them on average
  std::vector<double> hours_a_year;      ///< of each setting, see read_scatter(); empty: no levels of years
  std::vector<double> years{1.0, 10.0, 50.0, 100.0};  ///< return periods of levels over all settings
  std::vector<double> exponents;                      ///< of damage-equivalent loads
  double frequency = 1.0;                             ///< of their sinusoid [Hz]
};

/// Widest 90 % interval of the load that 84 % of ten-minute maxima stay below, over that load: IEC 61400-1:2019, Annex
/// G.
inline constexpr double kWidestOfTenMinutes = 0.15;

/// The return period of an annual probability of exceedance in (0, 1) [years].
double years_of(double annual_probability);

/// One setting with the extremes of all its replicates.
struct DesignState {
  const SettingHistories* setting = nullptr;
  statistics::ExtremeValues extremes;
  std::optional<std::size_t> in_tail;  ///< its place there; absent: too few peaks
  double hours_a_year = 0.0;

  double records(double hours) const { return 3600.0 * hours / extremes.duration; }
};

/// The answer: for JSON, and for its picture.
struct Design {
  nlohmann::ordered_json json;
  std::vector<DesignState> states;
  std::optional<statistics::SharedTail> tail;
  std::string unit;

  /// For the load of some hours of one state.
  statistics::Exposure exposure(const DesignState& state, double hours) const;
  /// For the load of some years of all states.
  statistics::Exposure exposure(double years) const;
};

/// Pools the replicates of each setting, and fits one tail to the peaks of all of them: levels for hours of exposure,
/// levels of return periods over all settings, and equivalent loads.
Design design_of(const std::vector<SettingHistories>& settings, const DesignSettings& asked);

/// The same as text for a reader.
std::string design_text(const nlohmann::ordered_json& design);

/// Hours a year of each setting, in their order; 0 where the table lacks it.
///
/// @param path  CSV whose columns are varied keys, in SI or as the plan writes texts, and `hours`.
/// @throws InputError when the table names a state that the campaign lacks.
std::vector<double> read_scatter(const std::string& path, const std::vector<SettingHistories>& settings);

}  // namespace brash::analysis
