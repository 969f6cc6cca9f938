// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>

#include "brash/campaign/campaign.hpp"
#include "brash/core/error.hpp"
#include "brash/core/version.hpp"
#include "campaign_commands.hpp"
#include "commands.hpp"
#include "failure_commands.hpp"
#include "geometry_commands.hpp"
#include "stats_commands.hpp"

namespace {

constexpr int kFailed = 1;
constexpr int kBadInput = 2;
constexpr int kInterrupted = 3;

}  // namespace

/// Exit codes: 0 done, 1 failed while running, 2 bad input, 3 interrupted and resumable.
int main(int argc, char** argv) {
  CLI::App app{"brash: how a structure breaks level ice", "brash"};
  app.set_version_flag("--version", brash::kVersion);
  app.require_subcommand(1);
  app.footer("Example: brash run experiments/validation/cone.toml -o results/validation");
  brash::cli::add_run_command(app);
  brash::cli::add_check_command(app);
  brash::cli::add_schema_command(app);
  brash::cli::add_campaign_commands(app);
  brash::cli::add_crack_command(app);
  brash::cli::add_fit_command(app);
  brash::cli::add_failure_command(app);
  brash::cli::add_loads_command(app);
  brash::cli::add_stats_command(app);
  brash::cli::add_compare_command(app);
  brash::cli::add_trend_command(app);
  brash::cli::add_report_command(app);
  brash::cli::add_export_command(app);
  brash::cli::add_rerun_command(app);
  brash::cli::add_completion_command(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kBadInput;
  } catch (const brash::InputError& error) {
    fmt::print(stderr, "brash: {}\n", error.what());
    return kBadInput;
  } catch (const brash::cli::Interrupted& stop) {
    fmt::print(stderr, "brash: {}\n", stop.what());
    return kInterrupted;
  } catch (const brash::cli::CaseNotStored& error) {
    fmt::print(stderr, "{}\n", error.what());
    return brash::campaign::kStorageExit;
  } catch (const std::exception& error) {
    fmt::print(stderr, "brash: {}\n", error.what());
    return kFailed;
  }
  return 0;
}
