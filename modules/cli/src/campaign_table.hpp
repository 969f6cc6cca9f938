// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace brash::cli {

/// How many done cases of a setting in a campaign's summary coincide with an earlier replicate.
int n_repeated(const nlohmann::ordered_json& setting);

/// The means of each setting with their 95 % intervals as a table, and the warnings of all cases, each once.
/// @param summary_file  of a campaign. @throws InputError when it cannot be read.
std::string means_table(const std::string& summary_file);

}  // namespace brash::cli
