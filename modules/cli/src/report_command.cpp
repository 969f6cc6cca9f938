// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <memory>

#include "brash/report/report.hpp"
#include "closed_forms.hpp"
#include "commands.hpp"

namespace brash::cli {

std::string write_report(const std::string& directory) {
  if (report::is_campaign(directory)) return report::write_campaign_report(directory);
  return report::write_run_report(directory, closed_form_loads(report::case_of_run(directory)).dump());
}

void add_report_command(CLI::App& app) {
  auto directory = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("report", "Write report.html of a run or a campaign: one file for any browser");
  command->add_option("directory", *directory, "folder of a run or a campaign")->required();
  command->footer("Example: brash report results/validation");
  command->callback([directory] { fmt::print("{}\n", write_report(*directory)); });
}

}  // namespace brash::cli
