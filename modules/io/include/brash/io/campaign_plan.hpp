// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brash/io/case.hpp"

namespace brash::io {

/// When the replicates of a setting are enough.
struct StopRule {
  std::string statistic;    ///< a column
  double half_width = 0.0;  ///< wanted half-width of the interval of its mean, over the magnitude of that mean [-]
  double confidence = 0.95;
  int most_replicates = 0;
  int batch = 1;  ///< replicates added at a time

  friend bool operator==(const StopRule&, const StopRule&) = default;
};

/// A key of the case file that the plan varies.
struct VariedKey {
  std::string name;  ///< "structure.angle"
  std::string unit;  ///< SI, "1" for ratios and values without unit

  friend bool operator==(const VariedKey&, const VariedKey&) = default;
};

/// The value of a varied key in one setting, from the resolved case.
struct SettingValue {
  std::string text;              ///< as a cell of a table
  std::optional<double> number;  ///< absent for texts and arrays

  friend bool operator==(const SettingValue&, const SettingValue&) = default;
};

/// One combination of the axes' values.
struct Setting {
  std::string name;                  ///< "angle-50deg_speed-0.5"; "base" without a grid
  std::vector<SettingValue> values;  ///< one a varied key
  model::Case resolved;              ///< its name keys the random streams

  friend bool operator==(const Setting&, const Setting&) = default;
};

/// A file as it was read.
struct SourceText {
  std::string path;
  std::string text;

  friend bool operator==(const SourceText&, const SourceText&) = default;
};

/// A plan, everything in it resolved and checked.
struct CampaignPlan {
  int replicates = 1;  ///< of each setting; the least number where there is a stop rule
  std::optional<StopRule> stop;
  std::string keep = "summary";      ///< summary | history | run
  std::vector<std::string> columns;  ///< numbers of a run's summary
  std::vector<VariedKey> keys;
  std::vector<Setting> settings;    ///< all combinations, the last axis fastest
  std::vector<SourceText> sources;  ///< the plan, and the base case where that is a file of its own
  bool quick = false;               ///< these three as PlanOptions had them
  std::optional<int> replicates_in_place;
  std::vector<std::string> overrides;

  friend bool operator==(const CampaignPlan&, const CampaignPlan&) = default;
};

/// How a plan is read.
struct PlanOptions {
  bool quick = false;                        ///< with the plan's [quick]
  std::optional<int> replicates = {};        ///< of each setting, in place of the plan's number and its [stop]
  std::vector<std::string> overrides;        ///< `section.key=value`, applied last to every case
  std::vector<std::string> known_columns;    ///< names allowed in `output.columns` and `stop.statistic`
  std::vector<std::string> default_columns;  ///< `output.columns` of a plan without that key
};

/// Reads, checks and resolves the plan of a campaign and each of its settings.
///
/// @throws InputError that lists every problem, each with file, line, column (or the override), key, value, the
///         allowed values, the nearest known name and the remedy.
/// @see docs/reference/plan.md.
CampaignPlan read_campaign_plan(const std::string& path, const PlanOptions& options);

/// The JSON Schema of a plan.
std::string plan_schema();

/// Warning of a case whose numbers equal the numbers of an earlier replicate to the last digit. Statistics count both
/// once.
inline constexpr const char* kRepeated = "same-as-a-replicate";

}  // namespace brash::io
