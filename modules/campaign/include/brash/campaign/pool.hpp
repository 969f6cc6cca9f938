// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace brash::campaign {

/// A process to start: no shell is involved.
struct Job {
  std::size_t ticket = 0;            ///< the caller's own number for it
  std::vector<std::string> command;  ///< the program's path and its arguments
  std::string messages;              ///< file that takes what it prints to stderr; its stdout is dropped
};

/// How a process ended: with an exit code, or by a signal (0: by none).
struct Exit {
  int code = 0;
  int signal = 0;

  friend bool operator==(const Exit&, const Exit&) = default;
};

/// What a pool asks for and tells.
struct PoolCalls {
  std::function<std::optional<Job>()> next;              ///< the job to start now; nothing when there is none now
  std::function<void(const Job&, const Exit&)> ended;    ///< may make new jobs available, or throw to stop
  std::function<void(std::size_t n_running)> idle = {};  ///< a few times a second, for progress
};

/// Runs jobs in at most `n_workers` processes at once until there are no more.
///
/// SIGINT, SIGTERM and SIGHUP are passed on to the running processes as SIGTERM; then no job is started any more. The
/// processes have ended when this returns or throws.
///
/// @return whether all jobs ran; false when it was interrupted.
/// @throws RunError when a process cannot be started.
bool run_pool(int n_workers, const PoolCalls& calls);

}  // namespace brash::campaign
