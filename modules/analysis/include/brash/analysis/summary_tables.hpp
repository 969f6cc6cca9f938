// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "brash/model/case.hpp"
#include "brash/simulation/run.hpp"

namespace brash::analysis {

/// The summary of a run as a table for people, the closed forms' peaks beside it.
std::string run_table(const model::Case& resolved, const simulation::Run& run);

/// The means of each setting with their 95 % intervals as a table, how many replicates would halve the intervals, and
/// the warnings of all cases, each once and with its words.
///
/// @param summary_file  of a campaign. @throws InputError when it cannot be read.
/// @param command       that ran the campaign, such as "brash campaign plan.toml -o results".
/// @param told          ids of the warnings whose words were printed before.
std::string means_table(const std::string& summary_file, const std::string& command, const std::set<std::string>& told);

/// How many done cases of a setting in a campaign's summary coincide with an earlier replicate.
int n_repeated(const nlohmann::ordered_json& setting);

}  // namespace brash::analysis
