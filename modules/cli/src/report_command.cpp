// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "commands.hpp"
#include "messages.hpp"
#include "run_folder.hpp"

namespace brash::cli {

void add_report_command(CLI::App& app) {
  auto directory = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("report", "Write report.html of a run or a campaign: one file for any browser");
  command->add_option("directory", *directory, "folder of a run or a campaign")->required();
  command->footer("Example: brash report results/validation");
  command->callback([directory] { print("{}\n", write_report(*directory)); });
}

}  // namespace brash::cli
