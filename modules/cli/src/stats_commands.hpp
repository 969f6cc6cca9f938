// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace brash::cli {

/// `brash stats FILE`; callbacks throw InputError.
void add_stats_command(CLI::App& app);
/// `brash compare RUN MEASURED`; callbacks throw InputError.
void add_compare_command(CLI::App& app);
/// `brash trend CAMPAIGN --along KEY`; callbacks throw InputError.
void add_trend_command(CLI::App& app);
/// `brash design CAMPAIGN`; callbacks throw InputError.
void add_design_command(CLI::App& app);
/// `brash resistance CASE.toml|CAMPAIGN`; callbacks throw InputError.
void add_resistance_command(CLI::App& app);
/// `brash loads CASE.toml`
void add_loads_command(CLI::App& app);

}  // namespace brash::cli
