// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstring>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>

#include "brash/advice/advice.hpp"
#include "brash/analysis/summary_tables.hpp"
#include "brash/core/error.hpp"
#include "brash/core/workers.hpp"
#include "brash/recording/inputs.hpp"
#include "brash/recording/recording.hpp"
#include "brash/recording/run_folder.hpp"
#include "brash/report/report.hpp"
#include "commands.hpp"
#include "live_view.hpp"
#include "messages.hpp"
#include "runs.hpp"

namespace brash::cli {
namespace {

struct RunOptions {
  std::string case_file;
  std::string directory;
  std::vector<std::string> overrides;
  std::int64_t seed = 0;
  bool has_seed = false;
  bool resume = false;
  bool replace = false;
  bool view = false;
  int threads = 0;  ///< 0: one for each processor
};

void refuse_two_seeds(const std::vector<std::string>& overrides) {
  for (const std::string& text : overrides)
    if (text.starts_with("random.seed") && text.find_first_not_of(' ', std::strlen("random.seed")) == text.find('='))
      throw InputError(
          Complaint{"--set " + text, "cannot be combined with --seed", "one seed", "remove one of the two"});
}

void run_case(const RunOptions& options) {
  std::vector<std::string> overrides = options.overrides;
  if (options.has_seed) refuse_two_seeds(overrides);
  if (options.has_seed) overrides.push_back(fmt::format("random.seed={}", options.seed));
  const recording::Inputs inputs = recording::read_inputs(options.case_file, overrides);
  const model::Case& resolved = inputs.resolved;
  const auto setup = std::make_shared<const simulation::Setup>(resolved);
  say_warnings(advice::warnings_of(*setup));
  const std::string directory = options.directory.empty() ? "results/" + resolved.name : options.directory;
  const FolderLock lock = recording::open_run_folder(directory);
  const std::string checkpoint = directory + "/checkpoint.nc";
  const bool goes_on = options.resume && std::filesystem::exists(checkpoint);
  if (!goes_on && !options.replace) recording::refuse_replacing(directory, ", or take --replace");
  if (options.resume && !goes_on) say("warning: there is no {} to resume from: the run starts at 0 s\n", checkpoint);
  const recording::NewResults results(directory);
  simulation::RunOptions how{.setup = setup,
                             .begun =
                                 [&] {
                                   recording::expect_unchanged(inputs);
                                   results.begin();
                                   if (!goes_on) recording::remove_checkpoint(checkpoint);
                                 },
                             .checkpoint = recording::checkpoint_file(checkpoint, options.resume, inputs),
                             .threads = options.threads > 0 ? options.threads : Workers::available()};
  std::optional<LiveView> view;
  if (options.view) {
    catch_requests_to_end();  // whoever reads the address may ask for the end
    view.emplace(resolved).watch(how);
    say("watch at  {}\n", view->address());
  }
  const simulation::Run run = [&] {
    try {
      return run_with_progress(resolved, how);
    } catch (const std::exception& error) {  // whoever watches reads why
      if (view) view->end(fmt::format("The run failed. {}", error.what()));
      throw;
    }
  }();
  if (!run.complete && run.results.loads.empty()) {
    if (view) view->end("The run was stopped before its first step.");
    throw Interrupted(fmt::format("{}: interrupted before a step was done; the same command begins again", directory));
  }
  if (!run.complete) {
    const double reached = run.results.loads.back().time;
    if (view)
      view->end(fmt::format("The run was stopped at {:.10g} s. The same command with --resume continues it.", reached));
    throw Interrupted(fmt::format(
        "{}: interrupted at t = {:.10g} s; the same command with `--resume` continues from there", directory, reached));
  }
  report::write_results(results, inputs, run);
  if (view) view->end(fmt::format("The run is done. Its report is {}/report.html.", directory));
  print("{}\nresults in {}\n", analysis::run_table(resolved, run), directory);
  if (report::has_page()) print("report in  {}/report.html\n", directory);
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
  CLI::Option* resume = command->add_flag("--resume", options->resume,
                                          "continue from the newest checkpoint in the folder of the results");
  command->add_flag("--replace", options->replace, "begin at 0 s where the folder holds a run already")
      ->excludes(resume);
  constexpr int kMostThreads = 1024;
  command
      ->add_option("--threads", options->threads,
                   "how many share the work [one for each processor]; results do not depend on it")
      ->check(CLI::Range(1, kMostThreads));
  command->add_flag("--view", options->view, "show the run in a browser on this machine while it runs");
  command->footer("Example: brash run cone.toml -o results/cone --seed 2 --set \"ice.thickness='0.4 m'\"");
  command->callback([options, seed] {
    options->has_seed = seed->count() > 0;
    run_case(*options);
  });
}

}  // namespace brash::cli
