// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <map>

#include "brash/campaign/campaign.hpp"
#include "brash/campaign/pool.hpp"
#include "case_jobs.hpp"
#include "folder_lock.hpp"
#include "schedule.hpp"

namespace brash::campaign {

Counts run_local(const io::CampaignPlan& plan, const std::string& plan_file, const std::string& directory,
                 const LocalOptions& options) {
  const Folder folder(plan, directory);
  std::filesystem::create_directories(directory);
  const FolderLock lock(directory + "/campaign.lock", directory, 0.0);
  folder.prepare(options.resume);

  Schedule schedule(plan, folder);
  std::map<std::size_t, CaseKey> handed_out;
  const auto next = [&]() -> std::optional<Job> {
    const auto key = schedule.next();
    if (!key) return {};
    Job job = job_of(*key, folder, options.program, plan.keep);
    job.ticket = handed_out.size();
    handed_out.emplace(job.ticket, *key);
    return job;
  };
  const auto ended = [&](const Job& job, const Exit& exit) {
    const CaseKey& key = handed_out.at(job.ticket);
    judge(key, folder, exit);
    schedule.look_at(key);
  };
  const auto idle = [&](std::size_t n_running) {
    if (options.progress) options.progress(schedule.counts(), n_running);
  };
  run_pool(options.n_workers, {next, ended, idle});

  const Counts counts = schedule.counts();
  if (counts.n_missing() == 0) collect(plan, plan_file, directory);
  return counts;
}

}  // namespace brash::campaign
