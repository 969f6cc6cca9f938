// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <map>

#include "brash/campaign/campaign.hpp"
#include "brash/core/error.hpp"
#include "collect.hpp"
#include "folder_lock.hpp"
#include "schedule.hpp"

namespace brash::campaign {
namespace {

namespace fs = std::filesystem;

/// A campaign's folder, locked and prepared, and what is in it.
struct Opened {
  explicit Opened(const Campaign& campaign)
      : lock(take(campaign.directory)),
        folder(campaign.plan, campaign.directory),
        schedule((folder.prepare(campaign.resume), campaign.plan), folder) {}

  static FolderLock take(const std::string& directory) {
    std::error_code reason;
    fs::create_directories(directory, reason);
    if (reason)
      throw InputError(fmt::format("{}: cannot be made: {}\n  remedy:  check the path and its permissions", directory,
                                   reason.message()));
    const std::string path = directory + "/campaign.lock";
    std::optional<FolderLock> lock = FolderLock::take(path);
    if (!lock)
      throw InputError(fmt::format("{}: is in use by {}  remedy:  wait until it is over, or give another folder",
                                   directory, read_text(path)));
    return std::move(*lock);
  }

  FolderLock lock;
  Folder folder;
  Schedule schedule;
};

void refuse_if_in_queue(const std::string& directory) {
  if (!fs::exists(slurm_folder(directory)) || !is_in_queue(slurm_folder(directory))) return;
  throw InputError(
      directory + ": its cases are in Slurm's queue\n  remedy:  wait until they are over, or `scancel` the jobs that " +
      slurm_folder(directory) + "/submitted.json names");
}

}  // namespace

std::string slurm_folder(const std::string& directory) { return directory + "/slurm"; }

Counts run_local(const Campaign& campaign, int n_workers, const Progress& progress) {
  Opened opened(campaign);
  refuse_if_in_queue(campaign.directory);
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

Counts run_slurm(const Campaign& campaign, SlurmOptions slurm) {
  Opened opened(campaign);
  refuse_if_in_queue(campaign.directory);
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
