// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "brash/analysis/design.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"
#include "brash/io/file_names.hpp"
#include "brash/io/results.hpp"
#include "brash/report/pictures.hpp"
#include "commands.hpp"
#include "files.hpp"
#include "messages.hpp"

namespace brash::cli {
namespace {

struct DesignOptions {
  std::string campaign, where, picture, scatter;
  std::vector<double> annual;
  analysis::HistoryChoice choice;
  analysis::DesignSettings asked;
  double dead_band = 0.0;
  bool json = false;
};

void add_questions(CLI::App& command, DesignOptions& o) {
  command.add_option("--hours", o.asked.hours, "of exposure: loads that are exceeded once in them on average")
      ->take_all()
      ->allow_extra_args(false)
      ->check(CLI::Range(1e-3, 1e9))
      ->capture_default_str();
  CLI::Option* scatter =
      command.add_option("--scatter", o.scatter, "CSV of varied keys in SI and `hours` a year, one line a state");
  command.add_option("--years", o.asked.years, "return periods over all states of the table [years]")
      ->delimiter(',')
      ->check(CLI::Range(0.1, 1e7))
      ->capture_default_str()
      ->needs(scatter);
  command.add_option("--annual", o.annual, "annual probabilities of exceedance, beside the years")
      ->delimiter(',')
      ->check(CLI::Range(1e-7, 0.99))
      ->needs(scatter);
  CLI::Option* exponent =
      command.add_option("--exponent", o.asked.exponents, "of S-N curves, for damage-equivalent loads by rainflow")
          ->take_all()
          ->allow_extra_args(false)
          ->check(CLI::Range(1.0, 20.0));
  command.add_option("--frequency", o.asked.frequency, "of the equivalent sinusoid [Hz]")
      ->check(CLI::Range(1e-9, 1e9))
      ->capture_default_str()
      ->needs(exponent);
}

}  // namespace

void add_design_command(CLI::App& app) {
  auto options = std::make_shared<DesignOptions>();
  options->choice.column = "Fx";
  CLI::App* command = app.add_subcommand("design", "From a campaign's replicates to design loads, with intervals");
  command->add_option("campaign", options->campaign, "folder of a campaign that keeps histories, or its campaign.csv")
      ->required();
  command->add_option("--column", options->choice.column, "of the histories")->capture_default_str();
  command->add_flag("--negate", options->choice.negate, "multiply by -1, for extremes of a load below zero");
  command->add_option("--from", options->choice.from, "leave out what is earlier [s] [as each run's summary]");
  command->add_option("--where", options->where, "only settings whose name matches, such as 'angle-50deg_*'");
  add_questions(*command, *options);
  command->add_option("--dead-band", options->dead_band, "of load events, in deviations [5 x the noise floor]")
      ->check(CLI::Range(0.0, 100.0));
  command->add_option("-o,--output", options->picture, "also draw the levels to this SVG or PNG file");
  command->add_flag("--json", options->json, "as JSON");
  command->footer("Example: brash design results/thickness --hours 0.1 --scatter states.csv --exponent 5");
  command->callback([options, command] {
    DesignOptions& o = *options;
    o.choice.has_from = command->count("--from") > 0;
    o.choice.notes = say_note;
    if (command->count("--dead-band") > 0) o.asked.extremes.dead_band = o.dead_band;
    io::refuse_replacing_results(o.picture);
    if (!o.scatter.empty()) refuse_overwriting(o.picture, {o.scatter});
    check_picture_name(o.picture);
    const auto settings = analysis::read_campaign_histories(io::folder_of(o.campaign), o.choice, o.where);
    if (!o.scatter.empty()) o.asked.hours_a_year = analysis::read_scatter(o.scatter, settings);
    for (const double probability : o.annual) o.asked.years.push_back(analysis::years_of(probability));
    const analysis::Design design = analysis::design_of(settings, o.asked);
    if (!o.picture.empty()) write_picture(o.picture, report::design_picture(design, o.asked));
    print_data(o.json ? design.json.dump(2) + "\n" : escaped_lines(analysis::design_text(design.json)));
  });
}

}  // namespace brash::cli
