// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "brash/analysis/campaign_histories.hpp"
#include "brash/statistics/extreme_analysis.hpp"
#include "brash/statistics/long_term.hpp"

namespace brash::analysis {

/// Questions to a campaign.
struct DesignSettings {
  statistics::ExtremeSettings extremes;    ///< its return period is not used
  std::vector<double> hours{1.0};          ///< of exposure: levels that are exceeded once in them on average
  std::vector<double> annual{1e-2, 1e-4};  ///< annual probabilities, with a scatter table
  std::vector<double> exponents;           ///< of damage-equivalent loads
  double frequency = 1.0;                  ///< of their sinusoid [Hz]
  std::string scatter;                     ///< file: hours a year of each state of the ice; empty: none
};

/// One setting with its pooled extremes.
struct DesignState {
  const SettingHistories* setting = nullptr;
  statistics::ExtremeAnalysis extremes;
  double hours = 0.0;  ///< a year, of the scatter table
};

/// The answer: for JSON, and what its picture is drawn from.
struct Design {
  nlohmann::ordered_json json;
  std::vector<DesignState> states;
  std::optional<statistics::LongTerm> long_term;
  std::string unit;
};

/// Pools the replicates of each setting: levels for hours of exposure, equivalent loads, and, with a scatter table,
/// levels of annual probabilities over all settings.
/// @throws InputError when the scatter table names a state that the campaign lacks.
Design design_of(const std::vector<SettingHistories>& settings, const DesignSettings& asked);

/// The same as text for a reader.
std::string design_text(const nlohmann::ordered_json& design);

/// Hours a year of each setting, in their order; 0 where the table lacks it.
///
/// @param path  CSV whose columns are varied keys, in SI or as the plan writes texts, and `hours`.
std::vector<double> read_scatter(const std::string& path, const std::vector<SettingHistories>& settings);

}  // namespace brash::analysis
