// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <memory>

#include "closed_forms.hpp"
#include "stats_commands.hpp"

namespace brash::cli {
namespace {

using nlohmann::ordered_json;

constexpr double kKilo = 1e3;
}  // namespace

std::string loads_text(const ordered_json& loads) {
  std::string text = fmt::format("{}: closed-form loads [kN], {}\n  horizontal  vertical  method\n",
                                 loads["case"].get<std::string>(), loads["kind"].get<std::string>());
  for (const ordered_json& load : loads["loads"]) {
    const auto method = load["method"].get<std::string>(), source = load["source"].get<std::string>();
    if (load.contains("not_applicable")) {
      text += fmt::format("           -         -  {}; {}\n{:24}not applicable: {}\n", method, source, "",
                          load["not_applicable"].get<std::string>());
      continue;
    }
    const std::string vertical =
        load.contains("vertical") ? fmt::format("{:.1f}", load["vertical"].get<double>() / kKilo) : "-";
    text += fmt::format("  {:10.1f}{:>10}  {}; {}\n{:24}", load["horizontal"].get<double>() / kKilo, vertical, method,
                        source, "");
    std::string separator;
    for (const auto& [name, value] : load["components"].items()) {
      text += fmt::format("{}{} {:.1f}", separator, name, value.get<double>() / kKilo);
      separator = ", ";
    }
    text += load.contains("in_range") && !load["in_range"].get<bool>() ? "; outside the formula's range\n" : "\n";
  }
  return text;
}

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
    const ordered_json loads = closed_form_loads(io::read_case(options->case_file, options->overrides));
    fmt::print("{}", options->json ? loads.dump(2) + '\n' : loads_text(loads));
  });
}

}  // namespace brash::cli
