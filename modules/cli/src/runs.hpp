// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brash/model/case.hpp"
#include "brash/simulation/run.hpp"

namespace brash::cli {

/// Runs a case as `options` say, with a line of progress on a terminal. Ctrl-C, a terminal that closes, or a request to
/// end stops it after its step and, where there is a store, keeps a checkpoint; the run is then not complete.
simulation::Run run_with_progress(const model::Case& resolved, simulation::RunOptions options);

/// From here on Ctrl-C (SIGINT), a request to end (SIGTERM) and a terminal that closes (SIGHUP) do not end the process:
/// is_asked_to_end() reports them. The process continues to ignore signals that it was started to ignore, as under
/// nohup.
void catch_requests_to_end();

/// Whether the process was asked to end since.
bool is_asked_to_end();

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
