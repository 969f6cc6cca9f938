// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/campaign/pool.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <system_error>

#include "brash/core/error.hpp"
#include "brash/core/write_file.hpp"
#include "brash/io/results.hpp"
#include "brash/recording/recording.hpp"
#include "folder.hpp"

extern char** environ;  // POSIX

namespace brash::campaign {
namespace {

namespace fs = std::filesystem;

constexpr int kInterruptedExit = 3;
constexpr int kWakeSignals[] = {SIGCHLD, SIGINT, SIGTERM, SIGHUP};

bool is_ignored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

/// While it lives, the signals that a pool waits for stay pending instead of acting. A pool does not
/// wait for signals that the process was started to ignore, as under nohup.
class HeldSignals {
 public:
  HeldSignals() {
    sigemptyset(&held_);
    for (const int signal : kWakeSignals)
      if (!is_ignored(signal)) sigaddset(&held_, signal);
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
    posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, messages.c_str(),
                                     O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW, 0666);
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
  // A file of an earlier process of the same number, or a link, is never opened.
  std::error_code is_not_there;
  fs::remove(job.messages, is_not_there);
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
    for (const auto& [process, job] : jobs_) {
      while (waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
      }
      std::error_code ignored;
      fs::remove(job.messages, ignored);
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

/// The end of the messages of a process, without trailing blanks; removes their file.
std::string take_last_words(const std::string& file) {
  constexpr std::size_t kMost = 4000;
  std::string text = read_text(file);
  std::error_code ignored;
  fs::remove(file, ignored);
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text.size() > kMost ? text.substr(text.size() - kMost) : text;
}

/// Keeps the state that a failed job has left beside its record, and names it in `error`.
void keep_state(const Job& job, std::string& error) {
  if (job.folder.empty()) return;
  const std::string left = job.folder + "/checkpoint.nc";
  const std::string kept = job.record + ".nc";
  if (recording::move_checkpoint(left, kept)) return;  // nothing is left
  for (std::size_t at = 0; (at = error.find(left, at)) != std::string::npos; at += kept.size())
    error.replace(at, left.size(), kept);
}

/// Writes down that a job failed on its own, and removes its files except its state.
void record_failure(const Job& job, const Exit& exit, std::string error) {
  keep_state(job, error);
  nlohmann::ordered_json record{{"case", fs::path(job.record).stem().string()}, {"error", error}};
  if (exit.signal != 0)
    record["signal"] = sigabbrev_np(exit.signal);
  else
    record["exit_code"] = exit.code;
  write_file(job.record, record.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  fs::remove_all(job.folder);
}

void judge(const Job& job, const Exit& exit, std::string error) {
  constexpr int kFromOutside[] = {SIGKILL, SIGTERM, SIGINT, SIGHUP};
  if (exit == Exit{} || exit.code == kInterruptedExit || std::ranges::count(kFromOutside, exit.signal) > 0) return;
  if (exit.code == kStorageExit) {
    // A disk may be too full for the worker's own words, which are in a file beside its results.
    if (error.empty())
      error = fmt::format("{}: cannot be written: {}\n  remedy:  check that its folder may be written and has space",
                          job.folder.empty() ? job.messages : job.folder,
                          std::make_error_code(std::errc::no_space_on_device).message());
    throw StorageError(error);
  }
  if (exit.signal != 0) error += fmt::format("{}ended by SIG{}", error.empty() ? "" : "\n", sigabbrev_np(exit.signal));
  if (job.record.empty()) throw RunError(error);
  record_failure(job, exit, error);
}

}  // namespace

bool is_over(const Job& job) { return fs::exists(job.result) || (!job.record.empty() && fs::exists(job.record)); }

std::string this_program() { return fs::read_symlink("/proc/self/exe").string(); }

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
    while (const auto ended = running.take_ended()) {
      judge(ended->first, ended->second, take_last_words(ended->first.messages));
      calls.ended(ended->first);
    }
    if (calls.idle) calls.idle(running.size());
  }
}

bool run_jobs(int n_workers, const std::vector<Job>& jobs, const std::function<void(std::size_t)>& progress) {
  std::size_t n_started = 0;
  std::size_t n_ended = 0;
  const auto next = [&]() -> std::optional<Job> {
    while (n_started < jobs.size() && is_over(jobs[n_started])) ++n_started;
    if (n_started == jobs.size()) return {};
    return jobs[n_started++];
  };
  const auto ended = [&](const Job&) {
    if (progress) progress(++n_ended);
  };
  return run_pool(n_workers, {next, ended});
}

}  // namespace brash::campaign
