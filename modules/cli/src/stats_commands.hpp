// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "brash/io/case.hpp"
#include "load_history.hpp"

namespace brash::cli {

/// Statistics of a load history, in the unit of the file; keys as in summary.json where both have them.
///
/// @param return_period  of the level that peaks over a threshold give [s].
nlohmann::ordered_json statistics_of(const LoadHistory& history, double return_period);

/// The same, and closed-form loads, as text for a reader.
std::string statistics_text(const nlohmann::ordered_json& statistics);
std::string loads_text(const nlohmann::ordered_json& loads);

/// `brash stats FILE`; callbacks throw InputError.
void add_stats_command(CLI::App& app);
/// `brash loads CASE.toml`
void add_loads_command(CLI::App& app);

}  // namespace brash::cli
