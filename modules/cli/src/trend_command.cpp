// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <memory>

#include "brash/analysis/trend.hpp"
#include "brash/core/text.hpp"
#include "brash/io/file_names.hpp"
#include "commands.hpp"
#include "messages.hpp"

namespace brash::cli {

void add_trend_command(CLI::App& app) {
  struct Options {
    std::string campaign;
    analysis::TrendSettings asked;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("trend", "Tests whether a result rises or falls along a campaign's grid");
  command->add_option("campaign", options->campaign, "folder of a campaign, or its campaign.csv")->required();
  command->add_option("--along", options->asked.along, "key of the grid, such as structure.angle")->required();
  command->add_option("--of", options->asked.of, "columns; their p-values are adjusted for their number")
      ->take_all()
      ->allow_extra_args(false)
      ->capture_default_str();
  command->add_option("--where", options->asked.where, "only settings whose name matches, such as 'angle-50deg_*'");
  command->add_flag("--json", options->json, "as JSON");
  command->footer("Example: brash trend results/angle_velocity --along structure.angle --where '*_speed-2.0'");
  command->callback([options] {
    const nlohmann::ordered_json out =
        analysis::trends_of(io::file_in(options->campaign, {"campaign.csv"}), options->asked);
    print_data(options->json ? out.dump(2) + "\n" : escaped_lines(analysis::trend_text(out)));
  });
}

}  // namespace brash::cli
