// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <exception>
#include <new>
#include <sstream>
#include <system_error>

#include "brash/campaign/campaign.hpp"
#include "brash/core/error.hpp"
#include "brash/core/version.hpp"
#include "brash/geometry/memory.hpp"
#include "commands.hpp"
#include "messages.hpp"
#include "runs.hpp"
#include "usage_error.hpp"

namespace {

using brash::cli::say;

constexpr int kFailed = 1;
constexpr int kBadInput = 2;
constexpr int kInterrupted = 3;

/// Runs the command of the arguments. @return the exit code. @throws RunError when not all that it prints can be
/// written.
int run(CLI::App& app, int argc, char** argv) {
  int code = 0;
  std::error_code failure;
  if (argc < 2) {
    say("{}", app.help());
    return kBadInput;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream out;
    std::ostringstream err;
    code = app.exit(error, out, err) == 0 ? 0 : kBadInput;
    brash::cli::say_text(err.str());
    brash::cli::print_text(out.str());
  } catch (const std::system_error& error) {
    if (std::ferror(stdout) == 0) throw;
    failure = error.code();
  }
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  if (!failure) failure = {errno, std::generic_category()};
  if (failure == std::errc::broken_pipe) return kFailed;  // the reader has read enough, such as `head`
  throw brash::StorageError(
      fmt::format("the output cannot be written: {}\n  remedy:  check that there is space for it", failure.message()));
}

/// An empty name is most often of a variable of the shell that is not set, and no wish for the default.
void refuse_empty_names(CLI::App& app) {
  for (CLI::Option* const option : app.get_options())
    if (option->check_lname("output") || option->check_lname("picture"))
      option->check([](const std::string& name) { return std::string(name.empty() ? "the name is empty" : ""); });
  for (CLI::App* const command : app.get_subcommands([](CLI::App*) { return true; })) refuse_empty_names(*command);
}

/// A range of CLI11 takes "nan": no comparison with it holds, the one that would refuse it neither.
void refuse_what_is_no_number(CLI::App& app) {
  for (CLI::Option* const option : app.get_options())
    if (option->get_type_name().starts_with("FLOAT:"))
      option->check([](const std::string& text) {
        double value = 0.0;
        const bool is_number = !CLI::detail::lexical_cast(text, value) || std::isfinite(value);
        return is_number ? std::string() : fmt::format("'{}' is not a finite number", text);
      });
  for (CLI::App* const command : app.get_subcommands([](CLI::App*) { return true; }))
    refuse_what_is_no_number(*command);
}

/// "0.2.0 (commit 1a2b3c4d5e6f)"
std::string version_text() {
  const std::string commit = brash::kCommit;
  return brash::kVersion + (commit.empty() ? "" : " (commit " + commit + ")");
}

}  // namespace

/// Exit codes: 0 done, 1 failed while running, 2 bad input, 3 interrupted and resumable.
int main(int argc, char** argv) {
  brash::cli::secure_streams();
  brash::geometry::throw_where_memory_is_short();
  CLI::App app{"brash: how a structure breaks level ice", "brash"};
  app.set_version_flag("--version", version_text());
  app.require_subcommand(0, 1);  // a word that is not a subcommand is then named
  app.footer("Example: brash run experiments/validation/cone.toml -o results/validation");
  app.failure_message(brash::cli::usage_error);
  brash::cli::add_run_command(app);
  brash::cli::add_check_command(app);
  brash::cli::add_schema_command(app);
  brash::cli::add_new_command(app);
  brash::cli::add_campaign_commands(app);
  brash::cli::add_crack_command(app);
  brash::cli::add_fit_command(app);
  brash::cli::add_pieces_command(app);
  brash::cli::add_failure_command(app);
  brash::cli::add_loads_command(app);
  brash::cli::add_stats_command(app);
  brash::cli::add_compare_command(app);
  brash::cli::add_trend_command(app);
  brash::cli::add_design_command(app);
  brash::cli::add_resistance_command(app);
  brash::cli::add_report_command(app);
  brash::cli::add_export_command(app);
  brash::cli::add_rerun_command(app);
  brash::cli::add_completion_command(app);
  refuse_empty_names(app);
  refuse_what_is_no_number(app);
  try {
    return run(app, argc, argv);
  } catch (const brash::InputError& error) {
    say("brash: {}\n", error.what());
    return kBadInput;
  } catch (const brash::cli::Interrupted& stop) {
    say("brash: {}\n", stop.what());
    return kInterrupted;
  } catch (const brash::cli::CaseNotStored& error) {
    say("{}\n", error.what());
    return brash::campaign::kStorageExit;
  } catch (const std::bad_alloc&) {
    say("brash: there is not enough memory\n  remedy:  free some, or raise its limit; where the "
        "command has `--resume`, that continues from what it has kept\n");
    return kFailed;
  } catch (const std::exception& error) {
    say("brash: {}\n", error.what());
    return kFailed;
  }
}
