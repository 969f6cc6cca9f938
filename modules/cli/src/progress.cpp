// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

namespace brash::cli {
namespace {

/// Set by Ctrl-C or a request to end; the run then keeps a checkpoint after its step.
volatile std::sig_atomic_t interrupted = 0;
void interrupt(int) { interrupted = 1; }

/// A line on a terminal with time left, renewed a few times a second; silent elsewhere.
class ProgressLine {
 public:
  explicit ProgressLine(double duration) : duration_(duration), on_terminal_(isatty(STDERR_FILENO) != 0) {}
  ~ProgressLine() {
    if (on_terminal_) fmt::print(stderr, "\r\033[K");
  }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(double time, int n_floes) {
    using std::chrono::steady_clock;
    const auto now = steady_clock::now();
    if (!on_terminal_ || now - shown_ < std::chrono::milliseconds(200)) return;
    shown_ = now;
    const double wall = std::chrono::duration<double>(now - start_).count();
    fmt::print(stderr, "\r\033[K{:5.1f} of {:.1f} s  {:3.0f} %  {} floes  {:.0f} s left", time, duration_,
               100.0 * time / duration_, n_floes, wall * (duration_ - time) / time);
  }

 private:
  double duration_;
  bool on_terminal_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point shown_ = start_;
};

}  // namespace

simulation::Run run_with_progress(const io::Case& resolved, const std::string& checkpoint_file, bool resume) {
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  ProgressLine progress(resolved.time.duration);
  return simulation::run(resolved,
                         {.observer =
                              [&](const simulation::Simulation& simulation, const simulation::StepReport& report) {
                                progress.show(simulation.time(), report.loads.n_floes);
                              },
                          .checkpoint_file = checkpoint_file,
                          .resume = resume,
                          .interrupted = [] { return interrupted != 0; }});
}

}  // namespace brash::cli
