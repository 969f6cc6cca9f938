// SPDX-License-Identifier: GPL-3.0-or-later
#include "runs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <initializer_list>
#include <utility>

#include "brash/advice/advice.hpp"
#include "messages.hpp"

namespace brash::cli {

namespace {

/// A line with the time left: on a terminal renewed a few times a second, in a log a new one now and then.
class ProgressLine {
 public:
  explicit ProgressLine(double duration) : duration_(duration), on_terminal_(isatty(STDERR_FILENO) != 0) {}
  ~ProgressLine() {
    if (on_terminal_) cli::show("\r\033[K");
  }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(double time, int n_floes) {
    using std::chrono::steady_clock;
    const auto now = steady_clock::now();
    if (now - shown_ < (on_terminal_ ? kOnTerminal : kInLog)) return;
    shown_ = now;
    const double wall = std::chrono::duration<double>(now - start_).count();
    cli::show(fmt::format("{}{:5.1f} of {:.1f} s  {:3.0f} %  {} floes  {:.0f} s left{}", on_terminal_ ? "\r\033[K" : "",
                          time, duration_, 100.0 * time / duration_, n_floes, wall * (duration_ - time) / time,
                          on_terminal_ ? "" : "\n"));
  }

 private:
  static constexpr std::chrono::milliseconds kOnTerminal{200}, kInLog{30'000};
  double duration_;
  bool on_terminal_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point shown_ = start_;
};

volatile std::sig_atomic_t asked = 0;
void note(int) { asked = 1; }

}  // namespace

simulation::Run run_with_progress(const model::Case& resolved, simulation::RunOptions options) {
  catch_requests_to_end();
  ProgressLine progress(resolved.time.duration);
  options.observer = [&, observer = std::move(options.observer)](const simulation::Simulation& simulation,
                                                                 const simulation::StepReport& report) {
    if (observer) observer(simulation, report);
    progress.show(simulation.time(), report.loads.n_floes);
  };
  options.interrupted = [interrupted = std::move(options.interrupted)] {
    return is_asked_to_end() || (interrupted && interrupted());
  };
  return advice::run(resolved, options);
}

void catch_requests_to_end() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (std::signal(signal, note) == SIG_IGN) std::signal(signal, SIG_IGN);
}

bool is_asked_to_end() { return asked != 0; }

}  // namespace brash::cli
