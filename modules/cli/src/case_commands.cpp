// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "brash/io/campaign_plan.hpp"
#include "brash/io/case.hpp"
#include "brash/simulation/scales.hpp"
#include "commands.hpp"
#include "messages.hpp"
#include "table.hpp"

namespace brash::cli {
namespace {

void check_case(const std::string& path, const std::vector<std::string>& overrides) {
  const model::Case resolved = io::read_case(path, overrides);
  const simulation::DerivedScales scales = simulation::derived_scales(resolved);
  print_data(io::to_toml(resolved));
  const std::string keys = fmt::format("{}", fmt::join(io::keys_set_by_preset(path, overrides), ", "));
  print("\n# set by algorithm.preset = \"{}\": {}\n\n# derived\n", model::name_of(resolved.algorithm.preset),
        keys.empty() ? "nothing, each of its keys is written" : keys);
  print("# characteristic length l_c      {:.4g} m\n", scales.characteristic_length);
  print("# thickness / l_c                {:.4g}\n", scales.thickness_over_lc);
  print("# mu1 straight ahead             {:.4g}\n", scales.mu1);
  print("# freeboard, draft               {:.4g} m, {:.4g} m\n", scales.freeboard, scales.draft);
  print("# T_col of a piece l_c x l_c / 4 {:.4g} s\n", scales.collision_time);
  print("# initial crack radius           {:.4g} m\n", scales.initial_crack_radius);
  if (scales.correlation_length > 0.0) print("# correlation length of the ice  {:.4g} m\n", scales.correlation_length);
  print_warnings(scales.warnings);
}

}  // namespace

void add_check_command(CLI::App& app) {
  struct Options {
    std::string case_file;
    std::vector<std::string> overrides;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("check", "Read a case, print it in SI with derived lengths and warnings");
  command->add_option("case", options->case_file, "case file (TOML)")->required();
  command->add_option("--set", options->overrides, "section.key=value")->take_all()->allow_extra_args(false);
  command->footer("Example: brash check experiments/validation/cone.toml");
  command->callback([options] { check_case(options->case_file, options->overrides); });
}

void add_schema_command(CLI::App& app) {
  struct Options {
    bool as_template = false;
    bool of_plan = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("schema", "Print the schema of a case file");
  CLI::Option* as_template = command->add_flag("--template", options->as_template, "a commented case file instead");
  command->add_flag("--plan", options->of_plan, "the schema of a campaign's plan instead")->excludes(as_template);
  command->footer("Example: brash schema --template > mine.toml");
  command->callback([options] {
    print("{}", options->as_template ? io::case_template() : options->of_plan ? io::plan_schema() : io::case_schema());
  });
}

}  // namespace brash::cli
