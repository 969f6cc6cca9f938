// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "brash/analysis/load_history.hpp"
#include "brash/analysis/tables.hpp"
#include "brash/model/case.hpp"

namespace brash::analysis {

/// The load histories of one setting of a campaign.
struct SettingHistories {
  std::string name;               ///< "thickness-0.33m"
  nlohmann::ordered_json values;  ///< of the varied keys: numbers in SI, or text
  std::vector<LoadHistory> replicates;
  std::optional<model::Case> resolved;  ///< as the campaign left it
};

/// The resolved case of a setting; nothing when the campaign left none.
std::optional<model::Case> case_of_setting(const std::string& campaign, const std::string& setting);

/// Without a `from` of its own, `choice` takes the samples that the statistics in the `summary.json` of a run are of.
/// @throws InputError when the file does not say where they begin.
void begin_as_summary(HistoryChoice& choice, const std::string& summary);

/// Without a `from` of its own, `choice` takes the samples from start_beside() on, if there is one.
void begin_as_run(HistoryChoice& choice, const std::string& history);

/// The cases that campaign.csv counts as done, by setting. The folder cases/ may hold others: cases of an earlier plan,
/// and cases that ended after the tables were written.
/// @throws InputError when `folder` has no such table.
std::map<std::string, std::vector<std::string>> done_cases(const std::string& folder);

/// The same without replicates that coincide with an earlier one, for statistics.
std::map<std::string, std::vector<std::string>> counted_cases(const std::string& folder);

/// Whether a case of a campaign's table coincides with an earlier replicate. A table alone need not say so.
bool is_repeated(const TextTable& table, const TextTable::Row& row);

/// Reads one column of the replicates that campaign.csv counts as done, from the start of their statistics on.
///
/// @param choice  its `from`, where given, takes the place of `statistics_from` in the summary of each run.
/// @param where   only settings whose name matches, such as "angle-50deg_*"; empty: all.
/// @throws InputError when the folder is not a campaign, keeps no histories, or no setting matches.
std::vector<SettingHistories> read_campaign_histories(const std::string& folder, const HistoryChoice& choice,
                                                      const std::string& where);

}  // namespace brash::analysis
