// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/campaign/pool.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <csignal>
#include <ctime>
#include <map>
#include <system_error>

#include "brash/core/error.hpp"

extern char** environ;  // POSIX

namespace brash::campaign {
namespace {

constexpr int kWakeSignals[] = {SIGCHLD, SIGINT, SIGTERM, SIGHUP};

/// While it lives, the signals that a pool waits for stay pending instead of acting.
class HeldSignals {
 public:
  HeldSignals() {
    sigemptyset(&held_);
    for (const int signal : kWakeSignals) sigaddset(&held_, signal);
    sigprocmask(SIG_BLOCK, &held_, &before_);
  }
  ~HeldSignals() { sigprocmask(SIG_SETMASK, &before_, nullptr); }
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

  const sigset_t& before() const { return before_; }
  /// Waits for the next signal, a quarter of a second at most. @return it, or 0.
  int wait() const {
    const timespec quarter{0, 250'000'000};
    const int signal = sigtimedwait(&held_, nullptr, &quarter);
    return signal < 0 ? 0 : signal;
  }

 private:
  sigset_t held_{};
  sigset_t before_{};
};

class Attributes {
 public:
  explicit Attributes(const sigset_t& mask) {
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setsigmask(&attributes_, &mask);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK);
  }
  ~Attributes() { posix_spawnattr_destroy(&attributes_); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;
  const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_{};
};

/// stdin and stdout to nothing, stderr to `messages`.
class Streams {
 public:
  explicit Streams(const std::string& messages) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  }
  ~Streams() { posix_spawn_file_actions_destroy(&actions_); }
  Streams(const Streams&) = delete;
  Streams& operator=(const Streams&) = delete;
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

pid_t start(const Job& job, const sigset_t& mask) {
  std::vector<char*> arguments;
  for (const std::string& argument : job.command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  const Attributes attributes(mask);
  const Streams streams(job.messages);
  pid_t process = 0;
  const int status =
      posix_spawn(&process, arguments.front(), streams.get(), attributes.get(), arguments.data(), environ);
  if (status != 0)
    throw RunError(
        fmt::format("{}: cannot be started: {}", job.command.front(), std::generic_category().message(status)));
  return process;
}

/// The running processes of a pool; those left at the end are asked to stop and waited for.
class Running {
 public:
  explicit Running(const sigset_t& mask) : mask_(mask) {}
  ~Running() {
    ask_to_end();
    for (const auto& [process, job] : jobs_)
      while (waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
      }
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  std::size_t size() const { return jobs_.size(); }
  void add(Job job) {
    const pid_t process = start(job, mask_);
    jobs_.emplace(process, std::move(job));
  }
  void ask_to_end() const {
    for (const auto& [process, job] : jobs_) kill(process, SIGTERM);
  }
  /// Takes a process that has ended, if there is one.
  std::optional<std::pair<Job, Exit>> take_ended() {
    for (auto running = jobs_.begin(); running != jobs_.end(); ++running) {
      int status = 0;
      if (waitpid(running->first, &status, WNOHANG) != running->first) continue;
      std::pair<Job, Exit> ended{std::move(running->second), {}};
      if (WIFEXITED(status)) ended.second.code = WEXITSTATUS(status);
      if (WIFSIGNALED(status)) ended.second.signal = WTERMSIG(status);
      jobs_.erase(running);
      return ended;
    }
    return {};
  }

 private:
  sigset_t mask_;
  std::map<pid_t, Job> jobs_;
};

}  // namespace

bool run_pool(int n_workers, const PoolCalls& calls) {
  const HeldSignals signals;
  Running running(signals.before());
  bool interrupted = false;
  while (true) {
    while (!interrupted && running.size() < static_cast<std::size_t>(n_workers)) {
      std::optional<Job> job = calls.next();
      if (!job) break;
      running.add(std::move(*job));
    }
    if (running.size() == 0) return !interrupted;
    const int signal = signals.wait();
    if (signal != 0 && signal != SIGCHLD) {
      interrupted = true;
      running.ask_to_end();
    }
    while (const auto ended = running.take_ended()) calls.ended(ended->first, ended->second);
    if (calls.idle) calls.idle(running.size());
  }
}

}  // namespace brash::campaign
