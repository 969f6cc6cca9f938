// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

#include "brash/analysis/campaign_histories.hpp"
#include "brash/analysis/history_comparison.hpp"
#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"
#include "brash/io/file_names.hpp"
#include "brash/io/results.hpp"
#include "brash/io/run_summary.hpp"
#include "brash/report/pictures.hpp"
#include "commands.hpp"
#include "files.hpp"
#include "messages.hpp"
#include "time_span.hpp"

namespace brash::cli {
namespace {

namespace fs = std::filesystem;
using analysis::HistoryChoice;
using analysis::LoadHistory;

struct CompareOptions {
  std::string run, where, measured_where, picture = "comparison.svg";
  std::vector<std::string> measured;
  HistoryChoice of_run, of_measured;
  analysis::IceSpeeds speeds;
  bool json = false;
};

/// The history of a run's folder, or a given one. The statistics of a run begin as its summary says.
std::string run_history(const std::string& given, HistoryChoice& choice) {
  if (!fs::is_directory(given)) {
    analysis::begin_as_run(choice, given);
    return given;
  }
  if (const fs::path summary = fs::path(given) / "summary.json"; fs::exists(summary))
    analysis::begin_as_summary(choice, summary.string());
  return analysis::history_file(given);
}

/// The replicates of the one setting of a campaign that `where` leaves.
std::vector<LoadHistory> replicates(const std::string& campaign, const HistoryChoice& choice,
                                    const std::string& where) {
  auto settings = analysis::read_campaign_histories(campaign, choice, where);
  if (settings.size() == 1) return std::move(settings.front().replicates);
  std::vector<std::string> names;
  for (const analysis::SettingHistories& setting : settings) names.push_back(setting.name);
  throw InputError(Complaint{campaign, fmt::format("is the folder of a campaign with {} settings", settings.size()),
                             "one setting", fmt::format("choose one with --where: {}", fmt::join(names, ", "))});
}

/// Histories with doubtful gaps and runs with warnings are named, so that their numbers are read with care.
void note_doubts(const std::vector<LoadHistory>& loads) {
  const std::string& file = loads.front().file;
  const std::string name = loads.size() == 1 ? file : fmt::format("{} and {} more", file, loads.size() - 1);
  for (const std::string& warning : analysis::run_warnings(loads)) say("note: {}: {}\n", name, warning);
  for (const LoadHistory& load : loads)
    for (const std::string& doubt : {statistics::gap_warning(load.history, load.even), marker_warning(load.marker)})
      if (!doubt.empty()) say("note: {}: {}\n", load.file, doubt);
}

/// The histories of one side: of a file, of a run's folder, of one setting of a campaign.
std::vector<LoadHistory> side(const std::string& given, HistoryChoice choice, const std::string& where) {
  if (io::is_campaign(given)) return replicates(given, choice, where);
  const std::string file = run_history(given, choice);
  return {analysis::read_history(file, choice)};
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

std::vector<LoadHistory> measurements(const CompareOptions& options) {
  std::vector<LoadHistory> measured;
  for (const std::string& given : options.measured) {
    HistoryChoice choice = options.of_measured;
    // Another run has the column that is asked for; a measurement may name it otherwise.
    if (fs::is_directory(given)) {
      if (choice.column.empty()) choice.column = options.of_run.column;
      choice.dt = 0.0;  // its histories have times
    }
    for (LoadHistory& load : side(given, choice, options.measured_where)) measured.push_back(std::move(load));
  }
  return measured;
}

/// A pattern chooses a setting of a campaign; of anything else there is nothing to choose.
void check_patterns(CompareOptions& options) {
  const bool measured = std::ranges::any_of(options.measured, io::is_campaign);
  const auto refuse = [](const std::string& option, const std::string& given, const std::string& allowed) {
    throw InputError(Complaint{given, fmt::format("is not a campaign of which {} could choose a setting", option),
                               allowed, fmt::format("leave {} out, or give the folder of a campaign", option)});
  };
  if (!options.measured_where.empty() && !measured)
    refuse("--measured-where", options.measured.front(), "the folder of a campaign on the measured side");
  if (!options.where.empty() && !io::is_campaign(options.run) && !measured)
    refuse("--where", options.run, "the folder of a campaign on one side at least");
  if (options.measured_where.empty()) options.measured_where = options.where;
}

void compare(CompareOptions& options) {
  check_patterns(options);
  io::refuse_replacing_results(options.picture);
  for (const std::string& given : options.measured) refuse_overwriting(options.picture, {options.run, given});
  check_picture_name(options.picture);
  const std::vector<LoadHistory> runs = side(options.run, options.of_run, options.where);
  const std::vector<LoadHistory> measured = measurements(options);
  for (const LoadHistory& load : runs) refuse_overwriting(options.picture, {load.file});
  for (const LoadHistory& load : measured) refuse_overwriting(options.picture, {load.file});
  check_units(runs.front(), measured.front(), measured.front().file);
  nlohmann::ordered_json comparison = analysis::compare_histories(runs, measured, options.speeds);
  analysis::add_case_differences(runs, measured, comparison);
  write_picture(options.picture,
                report::comparison_picture(analysis::joined(runs), analysis::joined(measured), comparison));
  if (options.json) {
    print_data(comparison.dump(2) + "\n");
  } else {
    print("{}{}picture in {}\n", analysis::case_differences_text(comparison), analysis::comparison_text(comparison),
          options.picture);
  }
  note_doubts(runs);
  note_doubts(measured);
  if (measured.front().unit.empty() && !fs::is_directory(options.measured.front()))
    say("note: the measured '{}' states no unit and was taken to be in {}\n", printable(measured.front().column),
        runs.front().unit.empty() ? "the unit of the run" : runs.front().unit);
}

}  // namespace

void add_compare_command(CLI::App& app) {
  auto options = std::make_shared<CompareOptions>();
  options->of_run.column = "Fx";
  CLI::App* command = app.add_subcommand("compare", "A run against a measured history, with intervals and a picture");
  command->add_option("run", options->run, "folder of a run or a campaign, its run.nc, or any history")->required();
  command->add_option("measured", options->measured, "CSV or netCDF files with times, or folders of other runs")
      ->required();
  command->add_option("--where", options->where, "setting of a campaign, such as 'angle-50deg_*', on both sides");
  command->add_option("--measured-where", options->measured_where, "setting of a measured campaign [as --where]");
  command->add_option("--column", options->of_run.column, "of the run")->capture_default_str();
  command->add_option("--measured-column", options->of_measured.column,
                      "[the first that is not the time; of a folder, the run's]");
  CLI::Option* from = command->add_option("--from", options->of_run.from, "of the run [s] [as its summary]");
  CLI::Option* measured_from =
      command->add_option("--measured-from", options->of_measured.from, "[s] [its start; of a run, as its summary]");
  command->add_option("--measured-dt", options->of_measured.dt, "time step of a file without times [s]")
      ->check(time_span());
  CLI::Option* speed = command
                           ->add_option("--speed", options->speeds.run,
                                        "of the ice past the run's structure [m/s], for growth with travel")
                           ->check(CLI::Range(1e-6, 50.0));
  speed->needs(command->add_option("--measured-speed", options->speeds.measured, "the same of the measurement [m/s]")
                   ->check(CLI::Range(1e-6, 50.0))
                   ->needs(speed));
  command
      ->add_option("--missing", options->of_measured.missing,
                   "value that stands for a missing one in the measurement, in its unit")
      ->take_all()
      ->allow_extra_args(false);
  command
      ->add_option("--gap", options->of_measured.longest_interval, "longest step of the measurement that is not a gap")
      ->check(time_span());
  command->add_option("-o,--output", options->picture, "picture, SVG or PNG")->capture_default_str();
  command->add_flag("--json", options->json, "as JSON");
  command->footer("Example: brash compare results/cone measured.csv --measured-column force -o comparison.svg");
  command->callback([options, from, measured_from] {
    options->of_run.has_from = from->count() > 0;
    options->of_run.notes = options->of_measured.notes = say_note;
    options->of_measured.has_from = measured_from->count() > 0;
    compare(*options);
  });
}

}  // namespace brash::cli
