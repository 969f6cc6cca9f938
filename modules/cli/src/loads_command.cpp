// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <vector>

#include "brash/advice/advice.hpp"
#include "brash/analysis/closed_forms.hpp"
#include "brash/analysis/tables.hpp"
#include "brash/core/text.hpp"
#include "brash/io/case.hpp"
#include "brash/io/origin.hpp"
#include "commands.hpp"
#include "messages.hpp"

namespace brash::cli {

using nlohmann::ordered_json;

void add_loads_command(CLI::App& app) {
  struct Options {
    std::string case_file;
    std::vector<std::string> overrides;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("loads", "Closed-form loads for a case: ISO 19906, Ralston, Nevel; Lindqvist for a [hull]");
  command->add_option("case", options->case_file, "case file (TOML)")->required();
  command->add_option("--set", options->overrides, "section.key=value")->take_all()->allow_extra_args(false);
  command->add_flag("--json", options->json, "as JSON, SI");
  command->footer("Example: brash loads experiments/validation/cone.toml");
  command->callback([options] {
    const model::Case resolved = io::read_case(options->case_file, options->overrides);
    ordered_json loads = analysis::closed_form_loads(resolved);
    analysis::add_origin(io::origin_of(resolved), loads);
    const std::vector<model::Warning> warnings = advice::warnings_of(resolved);
    loads["warnings"] = ordered_json::array();
    for (const model::Warning& warning : warnings)
      loads["warnings"].push_back({{"id", warning.id}, {"text", warning.text}});
    print_data(options->json ? loads.dump(2) + "\n"
                             : escaped_lines(analysis::origin_text(loads) + analysis::loads_text(loads)));
    say_warnings(warnings);
  });
}

}  // namespace brash::cli
