// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace brash::campaign {

/// The path of the running program: `brash` starts itself for the parts of its work.
std::string this_program();

/// A process to start: no shell is involved.
struct Job {
  std::size_t ticket = 0;            ///< the caller's own number for it
  std::vector<std::string> command;  ///< the program's path and its arguments
  std::string messages;              ///< file that takes its stderr while it runs; stdout is dropped
  std::string folder;                ///< that it works in and makes; removed when it fails, its state kept
  std::string result;                ///< file that is there when the job is done
  std::string record;                ///< file that says why the job failed on its own; empty: the pool stops then
};

/// Whether a job is done, or has failed on its own.
bool is_over(const Job& job);

/// How a process ended: with an exit code, or by a signal (0: by none).
struct Exit {
  int code = 0;
  int signal = 0;

  friend bool operator==(const Exit&, const Exit&) = default;
};

/// Exit code of a job that the system, not the job itself, kept from its end: it stays to be done.
inline constexpr int kStorageExit = 4;

/// The callbacks of a pool.
struct PoolCalls {
  std::function<std::optional<Job>()> next;              ///< the job to start now; nothing when there is none now
  std::function<void(const Job&)> ended;                 ///< may make new jobs available
  std::function<void(std::size_t n_running)> idle = {};  ///< a few times a second, for progress
};

/// Runs jobs in at most `n_workers` processes at once until there are no more.
///
/// A job that ends with exit code 0 is done. One that ends with code 3, or is killed from outside (SIGKILL, SIGTERM,
/// SIGINT, SIGHUP), was interrupted: it stays to be done. Any other end is its own failure: `record` says so, and its
/// folder is removed. SIGINT, SIGTERM and SIGHUP are passed on to the running processes as SIGTERM;
/// then no job is started any more. The processes have ended when this returns or throws.
///
/// @return whether all jobs ran; false when it was interrupted.
/// @throws RunError when a process cannot be started, a job without a record failed. @throws StorageError when a job
///         ended with kStorageExit: no other job could write its files either.
bool run_pool(int n_workers, const PoolCalls& calls);

/// The same for a list of jobs; those whose result or record is there are skipped.
bool run_jobs(int n_workers, const std::vector<Job>& jobs,
              const std::function<void(std::size_t n_ended)>& progress = {});

}  // namespace brash::campaign
