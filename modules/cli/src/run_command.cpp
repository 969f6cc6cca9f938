// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <memory>

#include "brash/report/plan_view.hpp"
#include "brash/report/report.hpp"
#include "brash/simulation/run.hpp"
#include "commands.hpp"
#include "table.hpp"

namespace brash::cli {
namespace {

struct RunOptions {
  std::string case_file;
  std::string directory;
  std::vector<std::string> overrides;
  std::uint64_t seed = 0;
  bool has_seed = false;
  bool resume = false;
};

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

void run_case(const RunOptions& options) {
  std::vector<std::string> overrides = options.overrides;
  if (options.has_seed) overrides.push_back(fmt::format("random.seed={}", options.seed));
  const io::Case resolved = io::read_case(options.case_file, overrides);
  const std::string directory = options.directory.empty() ? "results/" + resolved.name : options.directory;
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  simulation::Run run;
  {
    ProgressLine progress(resolved.time.duration);
    run = simulation::run(resolved,
                          {.observer =
                               [&](const simulation::Simulation& simulation, const simulation::StepReport& report) {
                                 progress.show(simulation.time(), report.loads.n_floes);
                               },
                           .checkpoint_file = directory + "/checkpoint.nc",
                           .resume = options.resume,
                           .interrupted = [] { return interrupted != 0; }});
  }
  if (!run.complete)
    throw Interrupted(fmt::format("interrupted at t = {} s; `brash run {} -o {} --resume` goes on from there",
                                  run.results.loads.back().time, options.case_file, directory));
  io::write_file(directory + "/plan.svg", report::plan_view(resolved, run.results));
  simulation::write_run(directory, options.case_file, resolved, run, {"plan.svg"});
  fmt::print("{}\nresults in {}\n", run_table(resolved, run), directory);
  if (report::has_page()) fmt::print("report in  {}\n", write_report(directory));
}

}  // namespace

void add_run_command(CLI::App& app) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("run", "Simulate one case");
  command->add_option("case", options->case_file, "case file (TOML)")->required();
  command->add_option("-o,--output", options->directory, "folder of the results [results/<name of the case>]");
  CLI::Option* seed = command->add_option("--seed", options->seed, "seed of the random streams");
  command->add_option("--set", options->overrides, "section.key=value, in place of the case file's")
      ->take_all()
      ->allow_extra_args(false);
  command->add_flag("--resume", options->resume, "go on from the newest checkpoint in the folder of the results");
  command->footer("Example: brash run cone.toml -o results/cone --seed 2 --set \"ice.thickness='0.4 m'\"");
  command->callback([options, seed] {
    options->has_seed = seed->count() > 0;
    run_case(*options);
  });
}

}  // namespace brash::cli
