// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace CLI {
class App;
}

namespace brash::cli {

/// A run that was asked to stop and can be resumed. Exit code 3.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A case of a campaign that the system, not the case, kept from its end. Exit code campaign::kStorageExit.
class CaseNotStored : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Each adds one command to `app`; the command's callback does the work and throws InputError or RunError.
void add_run_command(CLI::App& app);
void add_check_command(CLI::App& app);
void add_schema_command(CLI::App& app);
void add_export_command(CLI::App& app);
void add_rerun_command(CLI::App& app);
void add_report_command(CLI::App& app);
void add_new_command(CLI::App& app);
void add_crack_command(CLI::App& app);
void add_fit_command(CLI::App& app);
void add_pieces_command(CLI::App& app);
void add_stats_command(CLI::App& app);
void add_compare_command(CLI::App& app);
void add_trend_command(CLI::App& app);
void add_design_command(CLI::App& app);
void add_resistance_command(CLI::App& app);
void add_loads_command(CLI::App& app);
/// Adds `failure database | train | predict`.
void add_failure_command(CLI::App& app);
/// Adds `failure database`, and `failure train`.
void add_database_command(CLI::App& failure);
void add_train_command(CLI::App& failure);
/// Adds `export openfast`.
void add_openfast_command(CLI::App& command);
/// Adds `campaign`, and `campaign-case`, which a campaign starts for each of its cases.
void add_campaign_commands(CLI::App& app);
/// Must be added last, because it lists the commands that are there.
void add_completion_command(CLI::App& app);

}  // namespace brash::cli
