// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>

#include "brash/analysis/campaign_histories.hpp"
#include "brash/analysis/history_statistics.hpp"
#include "brash/analysis/load_history.hpp"
#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"
#include "brash/core/write_file.hpp"
#include "brash/io/file_names.hpp"
#include "brash/io/results.hpp"
#include "brash/io/run_summary.hpp"
#include "brash/report/pictures.hpp"
#include "brash/simulation/warnings.hpp"
#include "commands.hpp"
#include "files.hpp"
#include "messages.hpp"
#include "time_span.hpp"

namespace brash::cli {
namespace {

using analysis::LoadHistory;
using nlohmann::ordered_json;

struct StatsOptions {
  std::vector<std::string> files, columns;
  std::string spectrum, events, exceedance, cycles, picture, phase = "zero";
  analysis::HistoryChoice choice;
  analysis::Preparation preparation;
  analysis::StatisticsSettings settings;
  double threshold = 0.0, dead_band = 0.0, to = 0.0;
  bool json = false;
};

/// Writes the table of each history into one file; of several, each line begins with file and column.
void write_table(const std::string& path, const std::vector<LoadHistory>& loads,
                 const std::function<analysis::CsvTable(const LoadHistory&)>& table_of) {
  if (path.empty()) return;
  std::string text;
  for (const LoadHistory& load : loads) {
    const analysis::CsvTable table = table_of(load);
    const std::string key = loads.size() > 1 ? fmt::format("{},{},", load.file, load.column) : "";
    if (text.empty()) text = (key.empty() ? "" : "file,column,") + table.names;
    for (std::size_t at = 0; at < table.lines.size();) {
      const std::size_t end = table.lines.find('\n', at) + 1;
      text += key + table.lines.substr(at, end - at);
      at = end;
    }
  }
  write_file(path, text);
}

void write_outputs(const StatsOptions& o, const std::vector<LoadHistory>& loads) {
  const auto& dead_band = o.settings.extremes.dead_band;
  write_table(o.spectrum, loads, [&](const auto& load) { return analysis::spectrum_table(load, o.settings.segment); });
  write_table(o.events, loads, [&](const auto& load) { return analysis::events_table(load, dead_band); });
  write_table(o.exceedance, loads, [&](const auto& load) { return analysis::exceedance_table(load, dead_band); });
  write_table(o.cycles, loads, [](const auto& load) { return analysis::cycles_table(load); });
  if (!o.picture.empty()) write_picture(o.picture, report::stats_picture(loads.front(), o.settings));
}

/// Refuses outputs that would replace an input, a result or each other, before anything is written.
void check_outputs(const StatsOptions& o) {
  const std::vector<std::string> outputs{o.spectrum, o.events, o.exceedance, o.cycles, o.picture};
  io::refuse_equal_names(outputs);
  for (const std::string& out : outputs) {
    io::refuse_replacing_results(out);
    // The cracks of a run lie beside its history.
    for (const std::string& file : o.files)
      refuse_overwriting(out, {file, (std::filesystem::path(file).parent_path() / "events.csv").string()});
  }
  check_picture_name(o.picture);
  const std::size_t n = o.files.size() * std::max(o.columns.size(), std::size_t{1});
  if (!o.picture.empty() && n > 1)
    throw InputError(Complaint{o.picture, fmt::format("--picture of {} histories", n), "one history",
                               "name one file and one --column"});
}

/// The start of a run's statistics [s], if --from does not replace it.
std::optional<double> start_of_summary(const StatsOptions& o, const std::string& file) {
  return o.choice.has_from ? std::nullopt : io::start_beside(file);
}

std::vector<LoadHistory> histories_of(const StatsOptions& o) {
  std::vector<LoadHistory> loads;
  for (const std::string& file : o.files) {
    analysis::HistoryChoice choice = o.choice;
    analysis::begin_as_run(choice, file);
    for (LoadHistory& load : analysis::read_histories(file, choice, o.columns))
      loads.push_back(o.preparation.any() ? analysis::prepared(load, o.preparation) : std::move(load));
  }
  return loads;
}

void run_stats(StatsOptions& o) {
  for (std::string& file : o.files) file = analysis::history_file(file);
  if (!std::isfinite(o.threshold))
    throw InputError(Complaint{o.files.front(), fmt::format("--threshold {} is not a load", o.threshold),
                               "a finite number in the unit of the column", "give a number"});
  check_outputs(o);
  const std::vector<LoadHistory> loads = histories_of(o);
  write_outputs(o, loads);
  ordered_json all = ordered_json::array();
  std::string text;
  for (const LoadHistory& load : loads) {
    ordered_json out = analysis::statistics_of(load, o.settings);
    if (o.preparation.any()) out["preparation"] = analysis::preparation_json(o.preparation);
    if (const auto start = start_of_summary(o, load.file)) {
      out["statistics_from"] = *start;
      if (!simulation::bear_interval(load.warnings)) out["mean_95"] = {nullptr, nullptr};  // as in the summary
    }
    for (const std::string& warning : analysis::run_warnings({&load, 1})) out["warnings"].push_back(warning);
    if (loads.size() > 1) text += load.file + "\n";
    text += analysis::statistics_text(out);
    if (loads.size() > 1) out = ordered_json{{"file", load.file}, {"statistics", out}};
    all.push_back(std::move(out));
  }
  if (o.json)
    print_data((loads.size() > 1 ? all : all.front()).dump(2) + "\n");
  else
    print_data(escaped_lines(text));
}

void add_reading_options(CLI::App& command, StatsOptions& o) {
  command.add_option("file", o.files, "CSV or netCDF files with times, or folders of runs")->required();
  command.add_option("--column", o.columns, "columns [the first that is not the time]")
      ->take_all()
      ->allow_extra_args(false);
  command.add_flag("--negate", o.choice.negate, "multiply by -1, for peaks and extremes of a load below zero");
  command.add_option("--from", o.choice.from,
                     "leave out what is earlier than this [s] [of a run, what its summary leaves out]");
  command.add_option("--to", o.to, "leave out what is later [s]");
  command.add_option("--dt", o.choice.dt, "time step of files without times [s]")->check(time_span());
  command.add_option("--gap", o.choice.longest_interval, "longest step that is not a gap [s] [5 x the median step]")
      ->check(time_span());
  command
      .add_option("--missing", o.choice.missing,
                  "value that stands for a missing one, in the file's unit, such as -9999")
      ->take_all()
      ->allow_extra_args(false);
  command.add_option("--resample", o.preparation.step, "new time step [s]")->check(time_span());
  CLI::Option* low_pass =
      command.add_option("--low-pass", o.preparation.low_pass, "cut-off of Butterworth's filter [Hz]")
          ->check(CLI::Range(1e-9, 1e9));
  command.add_option("--phase", o.phase, "of the filter: zero, or causal as in an instrument")
      ->check(CLI::IsMember({"zero", "causal"}))
      ->capture_default_str()
      ->needs(low_pass);
}

void add_estimate_options(CLI::App& command, StatsOptions& o) {
  statistics::ExtremeSettings& e = o.settings.extremes;
  command.add_option("--return-period", e.return_period, "of the extreme levels [s]")
      ->check(time_span())
      ->capture_default_str();
  command.add_flag("--extrapolate", e.extrapolate, "give levels for more than 30 times the record, marked");
  command.add_option("--block", e.block, "of block maxima [s] [20 autocorrelation times, 5 load cycles at least]")
      ->check(time_span());
  command.add_option("--threshold", o.threshold, "of extreme peaks [the largest tenth above it, 40 at least]");
  command.add_option("--dead-band", o.dead_band, "of load events, in deviations [5 x the noise floor]")
      ->check(CLI::Range(0.0, 100.0));
  command.add_option("--segment", o.settings.segment, "of the spectrum [s] [an eighth of the longest piece]")
      ->check(time_span());
  CLI::Option* exponent =
      command.add_option("--exponent", o.settings.exponents, "of S-N curves, for damage-equivalent loads by rainflow")
          ->take_all()
          ->allow_extra_args(false)
          ->check(CLI::Range(1.0, 20.0));
  command.add_option("--frequency", o.settings.frequency, "of the equivalent sinusoid [Hz]")
      ->check(CLI::Range(1e-9, 1e9))
      ->capture_default_str()
      ->needs(exponent);
}

void add_output_options(CLI::App& command, StatsOptions& o) {
  command.add_option("--spectrum", o.spectrum, "also write the spectrum with its 95 % band to this CSV file");
  command.add_option("--events", o.events, "also write the load events to this CSV file");
  command.add_option("--exceedance", o.exceedance, "also write time and events above fifty levels to this CSV file");
  command.add_option("--cycles", o.cycles, "also write the rainflow cycles to this CSV file");
  command.add_option("--picture", o.picture, "also draw the extremes and their checks to this SVG or PNG file");
  command.add_flag("--json", o.json, "as JSON");
}

}  // namespace

void add_stats_command(CLI::App& app) {
  auto options = std::make_shared<StatsOptions>();
  CLI::App* command = app.add_subcommand("stats", "Statistics of load histories, simulated or measured");
  add_reading_options(*command, *options);
  add_estimate_options(*command, *options);
  add_output_options(*command, *options);
  command->footer("Example: brash stats results/cone --column Fx");
  command->callback([options, command] {
    StatsOptions& o = *options;
    o.choice.has_from = command->count("--from") > 0;
    o.choice.notes = say_note;
    if (command->count("--to") > 0) o.choice.to = o.to;
    if (command->count("--threshold") > 0) o.settings.extremes.threshold = o.threshold;
    if (command->count("--dead-band") > 0) o.settings.extremes.dead_band = o.dead_band;
    if (o.phase == "causal") o.preparation.phase = statistics::Phase::kCausal;
    run_stats(o);
  });
}

}  // namespace brash::cli
