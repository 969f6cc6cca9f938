// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "brash/model/case.hpp"
#include "brash/simulation/run.hpp"

namespace brash::analysis {

/// The summary of a run as a table for people, the closed forms' peaks beside it.
std::string run_table(const model::Case& resolved, const simulation::Run& run);

/// The means of each setting of a campaign with their 95 % intervals as a table, and the warnings of all cases, each
/// once.
/// @param summary_file  of a campaign. @throws InputError when it cannot be read.
std::string means_table(const std::string& summary_file);

/// How many done cases of a setting in a campaign's summary coincide with an earlier replicate.
int n_repeated(const nlohmann::ordered_json& setting);

}  // namespace brash::analysis
