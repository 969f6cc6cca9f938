// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "brash/analysis/campaign_histories.hpp"
#include "brash/analysis/resistance.hpp"
#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"
#include "brash/core/write_file.hpp"
#include "brash/io/case.hpp"
#include "brash/io/run_summary.hpp"
#include "brash/report/pictures.hpp"
#include "commands.hpp"
#include "messages.hpp"
#include "runs.hpp"

namespace brash::cli {
namespace {

namespace fs = std::filesystem;

struct ResistanceOptions {
  std::string input;  ///< a case file, or the folder of a campaign
  PlanRun run;
  analysis::ResistanceGrid grid;
  double bollard = 0.0, open_water = 0.0;
  std::string thrust_table;
  double at_speed = analysis::kThreeKnots;
  bool plan_only = false, json = false;
};

std::optional<analysis::NetThrust> thrust_of(const ResistanceOptions& o) {
  if (!o.thrust_table.empty()) return analysis::NetThrust::from_table(o.thrust_table);
  if (o.bollard > 0.0) return analysis::NetThrust::from_bollard_pull(o.bollard, o.open_water);
  return std::nullopt;
}

void expect_grid(const ResistanceOptions& o) {
  if (!o.grid.thicknesses.empty() && !o.grid.speeds.empty() && !o.run.directory.empty()) return;
  throw InputError(Complaint{o.input, "is a case, and its grid is not whole",
                             "--thickness, --speed and -o FOLDER with a case, or the folder of a campaign alone",
                             "as in `brash resistance ship.toml --thickness 0.4,0.8 --speed 1,2 -o results/ship`"});
}

/// Writes the plan into the campaign's folder. With --resume it may differ from the one there: the campaign itself
/// refuses cases that do not fit.
void write_plan(ResistanceOptions& o) {
  expect_grid(o);
  const model::Case ship = io::read_case(o.input, o.run.overrides);
  const fs::path folder = fs::absolute(o.run.directory).lexically_normal();
  const std::string relative = fs::absolute(o.input).lexically_normal().lexically_relative(folder).string();
  const std::string text = analysis::resistance_plan(ship, relative, o.grid);
  o.run.plan_file = (fs::path(o.run.directory) / "plan.toml").string();
  std::error_code ignored;
  if (fs::exists(o.run.plan_file, ignored) && !o.run.resume && read_text_file(o.run.plan_file, "a plan (TOML)") != text)
    throw InputError(Complaint{o.run.plan_file, "is there already, and is another plan",
                               "a folder that is new or empty",
                               "give another folder, or add `--resume` to continue with a larger grid"});
  write_file(o.run.plan_file, text);
}

void show_resistance(const ResistanceOptions& o, const std::optional<analysis::NetThrust>& thrust,
                     const std::string& campaign) {
  const nlohmann::ordered_json found = analysis::resistance_of(campaign, thrust, o.at_speed);
  const fs::path folder(campaign);
  write_file((folder / "resistance.json").string(), found.dump(2) + "\n");
  write_file((folder / "resistance.csv").string(), analysis::resistance_csv(found));
  write_file((folder / "resistance.svg").string(), report::resistance_picture(found, thrust));
  if (o.json) return print_data(found.dump(2) + "\n");
  print_data(escaped_lines(analysis::resistance_text(found)));
  print("in {}: resistance.csv, resistance.json, resistance.svg\n", campaign);
}

/// Refuses options of runs for a campaign that has run.
void refuse_options_of_runs(const CLI::App& command) {
  for (const char* const name :
       {"--thickness", "--speed", "--output", "--replicates", "--lengths", "--jobs", "--set", "--resume", "--plan"})
    if (command.count(name) > 0)
      throw InputError(Complaint{name, "has no effect on a campaign that has run", "with the case of a ship",
                                 "give the case in place of the folder, or leave the option out"});
}

void run_resistance(ResistanceOptions& o, const CLI::App& command) {
  const auto thrust = thrust_of(o);  // a table that cannot be read is refused before the runs
  if (io::is_campaign(o.input)) {
    refuse_options_of_runs(command);
    return show_resistance(o, thrust, o.input);
  }
  write_plan(o);
  if (o.plan_only) {
    std::string set;
    for (const std::string& text : o.run.overrides) set += fmt::format(" --set \"{}\"", printable(text));
    return print("the plan is in {0}; `brash campaign {0} -o {1}{2}` runs it\n", o.run.plan_file, o.run.directory, set);
  }
  run_plan(o.run);
  show_resistance(o, thrust, o.run.directory);
}

CLI::Option* add_numbers(CLI::App& command, const char* name, std::vector<double>& values, const char* help) {
  return command.add_option(name, values, help)
      ->delimiter(',')
      ->take_all()
      ->allow_extra_args(false)
      ->check(CLI::PositiveNumber);
}

void add_grid(CLI::App& command, ResistanceOptions& o) {
  add_numbers(command, "--thickness", o.grid.thicknesses, "of the ice [m], as in 0.4,0.8,1.2");
  add_numbers(command, "--speed", o.grid.speeds, "of the ship through the ice [m/s], as in 0.5,1,2");
  command.add_option("-o,--output", o.run.directory, "folder of the campaign");
  command.add_option("--replicates", o.grid.replicates, "runs of each point")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command.add_option("--lengths", o.grid.lengths, "distance of a run in lengths of the hull; the last one counts")
      ->check(CLI::Range(0.05, 100.0))
      ->capture_default_str();
  command.add_option("--jobs", o.run.n_jobs, "runs at once [as many as there are cores]")->check(CLI::Range(1, 100000));
  command.add_option("--set", o.run.overrides, "section.key=value, for every run")->take_all()->allow_extra_args(false);
  command.add_flag("--resume", o.run.resume, "continue what the folder holds");
  command.add_flag("--plan", o.plan_only, "write the plan of the campaign; run nothing");
}

void add_thrust(CLI::App& command, ResistanceOptions& o) {
  CLI::Option* bollard = command.add_option("--bollard-pull", o.bollard, "of the ship [N]")->check(CLI::PositiveNumber);
  CLI::Option* open_water =
      command.add_option("--open-water-speed", o.open_water, "at full power [m/s]")->check(CLI::PositiveNumber);
  bollard->needs(open_water);
  open_water->needs(bollard);
  command
      .add_option("--thrust", o.thrust_table,
                  "CSV of the net thrust: columns `speed` [m/s] and `thrust` [N], in place "
                  "of the bollard pull")
      ->excludes(bollard);
  command.add_option("--at-speed", o.at_speed, "find the thickness at this speed [m/s] [three knots]")
      ->check(CLI::PositiveNumber);
}

}  // namespace

void add_resistance_command(CLI::App& app) {
  auto options = std::make_shared<ResistanceOptions>();
  CLI::App* command = app.add_subcommand(
      "resistance", "A ship's resistance over thickness and speed, and the speed that its thrust attains");
  command->add_option("input", options->input, "case of a ship (TOML), or the folder of such a campaign")->required();
  add_grid(*command, *options);
  add_thrust(*command, *options);
  command->add_flag("--json", options->json, "as JSON, SI");
  command->footer(
      "Example: brash resistance ship.toml --thickness 0.4,0.8 --speed 0.5,1,2 -o results/ship "
      "--bollard-pull 9e5 --open-water-speed 8");
  command->callback([options, command] { run_resistance(*options, *command); });
}

}  // namespace brash::cli
