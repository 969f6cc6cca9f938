// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"
#include "brash/core/write_file.hpp"
#include "brash/io/results.hpp"
#include "campaign_histories.hpp"
#include "history_comparison.hpp"
#include "messages.hpp"
#include "stats_commands.hpp"
#include "time_span.hpp"

namespace brash::cli {
namespace {

struct CompareOptions {
  std::string run, measured, picture = "comparison.svg";
  HistoryChoice of_run, of_measured;
  bool json = false;
};

/// The history of a run's folder. Its statistics begin at the same time as the statistics of its summary.
std::string run_history(const std::string& given, HistoryChoice& choice) {
  if (!std::filesystem::is_directory(given)) return given;
  if (std::filesystem::is_directory(given + "/cases"))
    throw InputError(Complaint{given, "is the folder of a campaign", "the folder of a run, or a history",
                               "give a folder in its cases/; output.keep = \"history\" in the plan keeps histories"});
  if (const std::string summary = given + "/summary.json"; !choice.has_from && std::filesystem::exists(summary)) {
    choice.from = statistics_from(summary);
    choice.has_from = true;
  }
  for (const char* name : {"/run.nc", "/history.csv"})
    if (std::filesystem::exists(given + name)) return given + name;
  throw InputError(Complaint{given, "neither run.nc nor history.csv is in it", "the folder of a run, or a history",
                             "give the folder that `brash run` wrote"});
}

/// Numbers in different units are not compared.
void check_units(const LoadHistory& run, const LoadHistory& measured, const std::string& measured_file) {
  if (run.unit.empty() || measured.unit.empty() || run.unit == measured.unit) return;
  throw InputError(Complaint{measured_file,
                             fmt::format("column '{}' is in '{}', the run's '{}' in '{}'", printable(measured.column),
                                         printable(measured.unit), printable(run.column), printable(run.unit)),
                             fmt::format("a unit of UDUNITS-2 that converts to {}, such as k{}", run.unit, run.unit),
                             "correct the unit in the file, or name another column with --measured-column"});
}

void compare(CompareOptions& options) {
  const std::string file = run_history(options.run, options.of_run);
  const std::string measured_file = run_history(options.measured, options.of_measured);
  // Another run has the column that is asked for; a measurement may name it otherwise.
  if (measured_file != options.measured && options.of_measured.column.empty())
    options.of_measured.column = options.of_run.column;
  refuse_overwriting(options.picture, {file, measured_file});
  const LoadHistory run = read_history(file, options.of_run);
  const LoadHistory measured = read_history(measured_file, options.of_measured);
  check_units(run, measured, measured_file);
  const nlohmann::ordered_json comparison = compare_histories(run, measured);
  write_file(options.picture, comparison_picture(run, measured, comparison));
  if (options.json) {
    print_data(comparison.dump(2) + "\n");
  } else {
    print("{}picture in {}\n", comparison_text(comparison), options.picture);
  }
  if (measured.unit.empty() && measured_file == options.measured)
    say("note: the measured '{}' states no unit and was taken to be in {}\n", printable(measured.column),
        run.unit.empty() ? "that of the run" : run.unit);
}

}  // namespace

void add_compare_command(CLI::App& app) {
  auto options = std::make_shared<CompareOptions>();
  options->of_run.column = "Fx";
  CLI::App* command = app.add_subcommand("compare", "A run against a measured history, with intervals and a picture");
  command->add_option("run", options->run, "folder of a run, its run.nc, or any history")->required();
  command->add_option("measured", options->measured, "CSV or netCDF file with times, or the folder of another run")
      ->required();
  command->add_option("--column", options->of_run.column, "of the run")->capture_default_str();
  command->add_option("--measured-column", options->of_measured.column,
                      "[the first that is not the time; of a folder, the run's]");
  CLI::Option* from = command->add_option("--from", options->of_run.from, "of the run [s] [as its summary]");
  CLI::Option* measured_from =
      command->add_option("--measured-from", options->of_measured.from, "[s] [its start; of a folder, as its summary]");
  command->add_option("--measured-dt", options->of_measured.dt, "time step of a file without times [s]")
      ->check(time_span());
  command->add_option("--gap", options->of_measured.longest_interval, "longest step of the measurement that is no gap")
      ->check(time_span());
  command->add_option("-o,--output", options->picture, "picture, SVG")->capture_default_str();
  command->add_flag("--json", options->json, "as JSON");
  command->footer("Example: brash compare results/cone measured.csv --measured-column force -o comparison.svg");
  command->callback([options, from, measured_from] {
    options->of_run.has_from = from->count() > 0;
    options->of_measured.has_from = measured_from->count() > 0;
    compare(*options);
  });
}

}  // namespace brash::cli
