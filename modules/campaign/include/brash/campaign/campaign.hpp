// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "brash/io/campaign_plan.hpp"

namespace brash::campaign {

/// The numbers that the summary of a run has, by their names in campaign.csv.
const std::vector<std::string>& known_columns();

/// How far a campaign is. With a stop rule `n_cases` grows until each setting has enough.
struct Counts {
  int n_cases = 0;
  int n_done = 0;
  int n_failed = 0;

  int n_missing() const { return n_cases - n_done - n_failed; }
  friend bool operator==(const Counts&, const Counts&) = default;
};

/// Counts the cases of `plan` in `directory`, which need not exist.
Counts count(const io::CampaignPlan& plan, const std::string& directory);

/// What surrounds a campaign on this machine.
struct LocalOptions {
  std::string program;  ///< path of the `brash` command, whose `campaign-case` runs one case
  int n_workers = 1;
  bool resume = false;  ///< goes on with the cases that `directory` holds; without it there may be none
  /// Called now and then with the number of cases that are running.
  std::function<void(const Counts&, std::size_t n_running)> progress = {};
};

/// Runs what is missing of `plan` in processes on this machine; when none is missing, writes campaign.csv, campaign.nc,
/// summary.json and manifest.json into `directory`. Done cases are left alone.
///
/// @param plan_file  path of the plan as given, hashed into the manifest.
/// @return the counts; cases are missing when it was interrupted or a case was killed from outside.
/// @throws InputError when another process works in `directory`, or it holds another campaign. @throws RunError when
///         the system refuses a file or a process.
Counts run_local(const io::CampaignPlan& plan, const std::string& plan_file, const std::string& directory,
                 const LocalOptions& options);

/// Writes the tables of a campaign that has no case missing.
/// @throws RunError naming the file and the reason. @throws InputError when a case's summary cannot be read.
void collect(const io::CampaignPlan& plan, const std::string& plan_file, const std::string& directory);

/// Exit code of `brash campaign-case` when the system, not the case, is at fault: the case stays missing.
inline constexpr int kStorageExit = 4;

/// How a case ends for the process that runs it.
enum class CaseEnd {
  kDone,
  kInterrupted,  ///< a checkpoint is kept
};

/// One case, in this process.
struct CaseTask {
  std::string case_file;  ///< of its setting
  int replicate = 0;
  std::string folder;  ///< of its results; until they are whole, `folder`.part
  std::string keep;    ///< summary | history | run
};

/// Runs a case, from its newest checkpoint where there is one.
/// @throws what the simulation throws when the case fails by itself. @throws StorageError when the system refuses a
/// file.
CaseEnd run_case(const CaseTask& task, const std::function<bool()>& interrupted);

}  // namespace brash::campaign
