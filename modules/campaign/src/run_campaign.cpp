// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <map>

#include "brash/campaign/campaign.hpp"
#include "brash/core/error.hpp"
#include "brash/core/folder_lock.hpp"
#include "collect.hpp"
#include "schedule.hpp"

namespace brash::campaign {
namespace {

namespace fs = std::filesystem;

void refuse_if_in_queue(const std::string& directory) {
  if (!fs::exists(slurm_folder(directory)) || !is_in_queue(slurm_folder(directory))) return;
  throw InputError(
      directory + ": its cases are in Slurm's queue\n  remedy:  wait until they are over, or `scancel` the jobs that " +
      slurm_folder(directory) + "/submitted.json names");
}

/// A campaign's folder, locked and prepared, and its content.
struct Opened {
  /// @param unfit  is called with a message for each done case that is not as the campaign made it, before the case is
  ///               removed.
  Opened(const Campaign& campaign, const std::function<void(const std::string& what)>& unfit)
      : lock(FolderLock::take_or_refuse(campaign.directory, "campaign.lock")),
        folder(campaign.plan, campaign.directory),
        schedule((prepare(folder, campaign, unfit), campaign.plan), folder) {}
  explicit Opened(const Campaign& campaign)
      : Opened(campaign, [&](const std::string& what) {
          if (campaign.unfit) campaign.unfit(what);
        }) {}

  FolderLock lock;
  Folder folder;
  Schedule schedule;

 private:
  static void prepare(Folder& folder, const Campaign& campaign,
                      const std::function<void(const std::string& what)>& unfit) {
    refuse_if_in_queue(campaign.directory);
    folder.prepare(campaign.resume);
    folder.remove_unfit(unfit);
  }
};

[[noreturn]] void refuse_unfit(const std::string& what) {
  throw InputError(what +
                   "\n  allowed: cases as the campaign made them\n  remedy:  continue with `--resume`, which runs "
                   "this case again");
}

}  // namespace

std::string slurm_folder(const std::string& directory) { return directory + "/slurm"; }

Counts run_local(const Campaign& campaign, int n_workers, const Progress& progress) {
  Opened opened(campaign);
  std::map<std::size_t, CaseKey> handed_out;
  const auto next = [&]() -> std::optional<Job> {
    const auto key = opened.schedule.next();
    if (!key) return {};
    Job job = opened.folder.job_of(*key, campaign.program);
    job.ticket = handed_out.size();
    handed_out.emplace(job.ticket, *key);
    return job;
  };
  const auto ended = [&](const Job& job) { opened.schedule.look_at(handed_out.at(job.ticket)); };
  const auto idle = [&](std::size_t n_running) {
    if (progress) progress(opened.schedule.counts(), n_running);
  };
  run_pool(n_workers, {next, ended, idle});

  const Counts counts = opened.schedule.counts();
  if (counts.n_missing() == 0) collect(campaign, opened.folder, opened.schedule);
  return counts;
}

Counts write_tables(const Campaign& campaign) {
  // Opening makes a folder.
  if (const Counts now = count(campaign.plan, campaign.directory); now.n_done + now.n_failed == 0)
    throw InputError(Complaint{campaign.directory, "holds no case of this plan that is done or failed",
                               "the folder of a campaign with a finished case", "run the campaign first"});
  const Opened opened(campaign, refuse_unfit);
  collect(campaign, opened.folder, opened.schedule);
  return opened.schedule.counts();
}

Counts run_slurm(const Campaign& campaign, SlurmOptions slurm) {
  Opened opened(campaign);
  std::vector<Job> jobs;
  while (const auto key = opened.schedule.next()) jobs.push_back(opened.folder.job_of(*key, campaign.program));
  const Counts counts = opened.schedule.counts();
  if (jobs.empty()) {
    collect(campaign, opened.folder, opened.schedule);
    return counts;
  }
  slurm.folder = slurm_folder(campaign.directory);
  slurm.name = "brash-" + fs::path(campaign.plan_file).stem().string();
  slurm.program = campaign.program;
  submit(jobs, slurm);
  return counts;
}

}  // namespace brash::campaign
