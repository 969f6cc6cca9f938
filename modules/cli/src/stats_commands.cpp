// SPDX-License-Identifier: GPL-3.0-or-later
#include "stats_commands.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"
#include "brash/core/write_file.hpp"
#include "brash/io/results.hpp"
#include "history_statistics.hpp"
#include "messages.hpp"
#include "time_span.hpp"

namespace brash::cli {
namespace {

using nlohmann::ordered_json;

void write_spectrum(const std::string& file, const LoadHistory& load, double segment) {
  const auto spectrum = spectrum_of(load, segment);
  if (!spectrum) throw InputError("--spectrum: the history or the segment is shorter than 16 samples");
  const statistics::Interval factors = statistics::spectrum_factors(*spectrum);
  std::string text = "frequency,density,lower_95,upper_95\n";
  for (std::size_t k = 0; k < spectrum->frequency.size(); ++k) {
    const double density = spectrum->density[k];
    text +=
        fmt::format("{},{},{},{}\n", spectrum->frequency[k], density, factors.lower * density, factors.upper * density);
  }
  write_file(file, text);
}

}  // namespace

void add_stats_command(CLI::App& app) {
  struct Options {
    std::string file, spectrum;
    HistoryChoice choice;
    StatisticsSettings settings;
    double threshold = 0.0;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("stats", "Statistics of a load history, simulated or measured");
  command
      ->add_option("file", options->file, "CSV or netCDF file with times, such as the history.csv or run.nc of a run")
      ->required();
  command->add_option("--column", options->choice.column, "which column [the first that is not the time]");
  CLI::Option* from = command->add_option("--from", options->choice.from, "leave out what is earlier [s]");
  const auto seconds = [&](const char* name, double& target, const char* meaning) {
    return command->add_option(name, target, meaning)->check(time_span());
  };
  seconds("--dt", options->choice.dt, "time step of a file without times [s]");
  seconds("--gap", options->choice.longest_interval, "longest step that is no gap [s] [5 x the median step]");
  seconds("--return-period", options->settings.return_period, "of the extreme levels [s]")->capture_default_str();
  seconds("--block", options->settings.block, "of block maxima [s] [20 autocorrelation times]");
  seconds("--segment", options->settings.segment, "of the spectrum [s] [an eighth of the longest piece]");
  CLI::Option* threshold = command->add_option("--threshold", options->threshold, "of extreme peaks [90 % quantile]");
  command->add_option("--spectrum", options->spectrum, "also write the spectrum with its 95 % band to this CSV file");
  command->add_flag("--json", options->json, "as JSON");
  command->footer("Example: brash stats results/cone/history.csv --column Fx --from 8");
  command->callback([options, from, threshold] {
    options->choice.has_from = from->count() > 0;
    if (!std::isfinite(options->threshold))
      throw InputError(Complaint{options->file, fmt::format("--threshold {} is no load", options->threshold),
                                 "a finite number in the unit of the column", "give a number"});
    if (threshold->count() > 0) options->settings.threshold = options->threshold;
    refuse_overwriting(options->spectrum, {options->file});
    const LoadHistory load = read_history(options->file, options->choice);
    if (!options->spectrum.empty()) write_spectrum(options->spectrum, load, options->settings.segment);
    const ordered_json out = statistics_of(load, options->settings);
    print_data(options->json ? out.dump(2) + "\n" : escaped_lines(statistics_text(out)));
  });
}

}  // namespace brash::cli
