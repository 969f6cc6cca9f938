// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brash/campaign/pool.hpp"

namespace brash::campaign {

/// How jobs are given to Slurm.
struct SlurmOptions {
  std::string folder;                  ///< takes lists of jobs, the numbers of submitted jobs, and their output
  std::string name;                    ///< of the jobs in the queue
  std::string program;                 ///< path of the `brash` command, whose `campaign-chunk` runs a part of the jobs
  int n_tasks = 1;                     ///< parts into which the jobs are divided: tasks of the array
  std::vector<std::string> sbatch;     ///< further options of sbatch
  std::vector<std::string> collector;  ///< command that runs when all parts have ended, however they ended
};

/// One submission.
struct SlurmJobs {
  std::string array;
  std::string collector;
};

/// Submits `jobs` as an array of tasks, each of which runs its part one after another, and a collector after it.
///
/// The collector is meant to submit the jobs that are still missing again. It gives up when three rounds in a row have
/// ended without a job that was done or failed on its own.
///
/// @throws InputError when an earlier submission is still in the queue. @throws RunError when sbatch fails, or in a
///         collector that gives up.
SlurmJobs submit(const std::vector<Job>& jobs, const SlurmOptions& options);

/// Whether something that was submitted from `folder` is in the queue. The calling job itself does not count.
/// @throws RunError when squeue cannot list the queue.
bool is_in_queue(const std::string& folder);

/// Runs part `chunk` of the jobs that `submit` listed in `list_file`. @return false when it was interrupted.
bool run_chunk(const std::string& list_file, std::size_t chunk);

}  // namespace brash::campaign
