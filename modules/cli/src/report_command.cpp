// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/io/file_names.hpp"
#include "brash/io/run_summary.hpp"
#include "brash/recording/run_folder.hpp"
#include "brash/report/report.hpp"
#include "commands.hpp"
#include "messages.hpp"
#include "time_span.hpp"

namespace brash::cli {
namespace {

struct ReportOptions {
  std::string directory, other, measured, output = "comparison.html";
  analysis::HistoryChoice of_measured;
};

report::RunSource run_in(const std::string& directory) {
  report::expect_manifest(directory);
  if (io::is_campaign(directory))
    throw InputError(Complaint{directory, "holds a campaign", "the folder of a run",
                               "give a folder under its cases/, or the campaign alone"});
  return report::report_source(directory);
}

void write(ReportOptions& options) {
  options.directory = io::folder_of(options.directory);
  if (!options.other.empty()) options.other = io::folder_of(options.other);
  if (options.other.empty() && options.measured.empty()) return print("{}\n", report::write_report(options.directory));
  report::RunSource run = run_in(options.directory);
  if (!options.measured.empty()) run.measured = report::measured_history(options.measured, options.of_measured);
  if (options.other.empty()) return print("{}\n", report::write_run_report(run));
  refuse_overwriting(options.output, {options.directory + "/run.nc", options.other + "/run.nc", options.measured});
  io::refuse_replacing_results(options.output);
  report::write_comparison(run, run_in(options.other), options.output);
  print("{}\n", options.output);
}

}  // namespace

void add_report_command(CLI::App& app) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App* command =
      app.add_subcommand("report", "Write report.html of a run or a campaign: one file for any browser");
  command->add_option("directory", options->directory, "folder of a run or a campaign, or a file in it")->required();
  CLI::Option* other = command->add_option("other", options->other, "folder of another run, to be shown beside it");
  command->add_option("-o,--output", options->output, "page of two runs [comparison.html]")->needs(other);
  CLI::Option* measured =
      command->add_option("--measured", options->measured, "CSV or netCDF file with times, drawn over the loads");
  command->add_option("--measured-column", options->of_measured.column, "[the first that is not the time]")
      ->needs(measured);
  command->add_option("--measured-dt", options->of_measured.dt, "time step of a file without times [s]")
      ->check(time_span())
      ->needs(measured);
  command->footer("Example: brash report results/validation --measured measured.csv");
  command->callback([options] {
    options->of_measured.notes = say_note;
    write(*options);
  });
}

}  // namespace brash::cli
