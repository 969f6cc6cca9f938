// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace brash::cli {

/// A plan to run on this machine.
struct PlanRun {
  std::string plan_file, directory;
  std::vector<std::string> overrides;  ///< `section.key=value`
  int n_jobs = 0;                      ///< cases at once; 0: as many as there are cores
  bool resume = false;
};

/// Runs a plan and leaves the tables of its campaign, with progress on stderr.
/// @throws Interrupted when cases are missing.
void run_plan(const PlanRun& run);

}  // namespace brash::cli
