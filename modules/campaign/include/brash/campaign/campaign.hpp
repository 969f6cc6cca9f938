// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "brash/campaign/slurm.hpp"
#include "brash/io/campaign_plan.hpp"

namespace brash::campaign {

/// The format that the manifest of a campaign names.
constexpr const char* kManifestFormat = "brash-campaign-manifest-1";

/// The numbers that the summary of a run can have, by their names in campaign.csv.
const std::vector<std::string>& known_columns();

/// Those that the summary of every run has.
const std::vector<std::string>& default_columns();

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

/// How many done cases lie in `directory` that `plan` does not have: of more replicates, or of other settings.
int count_beyond(const io::CampaignPlan& plan, const std::string& directory);

/// A campaign in its folder.
struct Campaign {
  io::CampaignPlan plan;
  std::string plan_file;  ///< as given, hashed into the manifest
  std::string directory;
  bool resume = false;  ///< continues with the cases that `directory` holds; without it there may be none
  std::string program;  ///< path of the `brash` command, whose `campaign-case` runs one case
  /// Called with a message for each done case that is not as the campaign made it, such as one whose history was cut.
  /// The case is run again.
  std::function<void(const std::string& what)> unfit{};
};

/// Called now and then with how far a campaign is, and how many cases are running.
using Progress = std::function<void(const Counts&, std::size_t n_running)>;

/// Runs the missing cases in `n_workers` processes on this machine; when none is missing, writes campaign.csv,
/// campaign.nc, summary.json and manifest.json. Done cases whose results have their hashes are left alone.
///
/// @return the counts; cases are missing when it was interrupted or a case was killed from outside.
/// @throws InputError when another process works in the folder, or it holds another campaign. @throws RunError when the
///         system refuses a file or a process.
Counts run_local(const Campaign& campaign, int n_workers, const Progress& progress = {});

/// Submits the missing cases to Slurm, with a collector that calls this again; when none is missing, writes the tables.
///
/// @param slurm  `folder`, `name` and `program` are set here.
/// @return the counts at submission.
/// @throws as run_local and submit do.
Counts run_slurm(const Campaign& campaign, SlurmOptions slurm);

/// Writes the tables of the cases that are done or failed so far, and runs nothing. A missing case has no row.
///
/// @return the counts.
/// @throws InputError when no case is done or failed, or one is not as the campaign made it, or as run_local does.
Counts write_tables(const Campaign& campaign);

/// The folder for the files of Slurm in the folder of a campaign.
std::string slurm_folder(const std::string& directory);

/// How a case ends for the process that runs it.
enum class CaseEnd {
  kDone,
  kInterrupted,  ///< a checkpoint is kept; or another process is at the case
};

/// One case, in this process.
struct CaseTask {
  std::string case_file;  ///< of its setting
  int replicate = 0;
  std::string folder;  ///< of its results; until they are whole, `folder`.part
  std::string keep;    ///< summary | history | run
};

/// Runs a case, from its newest checkpoint where there is one.
/// @throws the error of the simulation when the case fails on its own. @throws StorageError when the system refuses a
/// file.
CaseEnd run_case(const CaseTask& task, const std::function<bool()>& interrupted);

}  // namespace brash::campaign
