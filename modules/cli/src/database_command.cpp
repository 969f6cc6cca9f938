// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>

#include "brash/campaign/slurm.hpp"
#include "brash/core/folder_lock.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/sha256.hpp"
#include "brash/core/write_file.hpp"
#include "brash/io/file_names.hpp"
#include "brash/training/database.hpp"
#include "brash/training/edge_database.hpp"
#include "commands.hpp"
#include "messages.hpp"
#include "runs.hpp"

namespace brash::cli {
namespace {

struct DatabaseOptions {
  std::string plan;
  std::string output;
  std::string on = "local";
  int n_jobs = 0;  ///< 0: not given
  int chunk = -1;  ///< solve this one alone
  std::vector<std::string> sbatch;
};

[[noreturn]] void stop(int done, int total, const char* what) {
  throw Interrupted(fmt::format("stopped after {} of {} {}; the same command continues from here", done, total, what));
}

/// A process for each chunk that is missing.
template <typename Plan>
std::vector<campaign::Job> missing_jobs(const Plan& plan, const DatabaseOptions& options) {
  std::vector<campaign::Job> jobs;
  for (const int first : training::missing_chunks(plan, options.output)) {
    const std::string file = training::chunk_file(options.output, first);
    jobs.push_back({.command = {campaign::this_program(), "failure", "database", options.plan, "-o", options.output,
                                "--chunk", std::to_string(first)},
                    .messages = part_of(file + ".messages"),
                    .folder = {},
                    .result = file,
                    .record = {}});
  }
  return jobs;
}

/// Solves the missing chunks in several processes.
void solve_in_processes(const std::vector<campaign::Job>& jobs, int n_workers) {
  const bool terminal = ::isatty(STDERR_FILENO) == 1;
  const bool whole = campaign::run_jobs(n_workers, jobs, [&](std::size_t n_ended) {
    if (terminal) show(fmt::format("\r{} of {} missing chunks", n_ended, jobs.size()));
  });
  if (terminal) show("\n");
  const auto n_done = std::ranges::count_if(jobs, [](const auto& job) { return std::filesystem::exists(job.result); });
  if (!whole || n_done < std::ssize(jobs)) stop(static_cast<int>(n_done), static_cast<int>(jobs.size()), "chunks");
}

/// Solves the missing records on this machine, and puts the database together.
template <typename Plan>
void build_here(const Plan& plan, const std::string& output) {
  catch_requests_to_end();
  const bool terminal = ::isatty(STDERR_FILENO) == 1;
  const training::Progress progress = training::build(plan, output, [terminal](const training::Progress& now) {
    if (terminal) show(fmt::format("\r{} of {} geometries, {} not solved", now.done, now.total, now.failed));
    return !is_asked_to_end();
  });
  if (terminal) show("\n");
  if (progress.done < progress.total) stop(progress.done, progress.total, "geometries");
  print("database    {}\nsha256      {}\ngeometries  {}\nnot solved  {}\n", output, sha256_of_file(output),
        progress.total, progress.failed);
}

/// Submits the missing chunks; the collector is this command again.
void submit_chunks(const std::vector<campaign::Job>& jobs, const DatabaseOptions& options) {
  constexpr int kTasks = 100;
  const int n_tasks = options.n_jobs > 0 ? options.n_jobs : kTasks;
  std::vector<std::string> collector{
      campaign::this_program(),         "failure", "database", options.plan, "-o", options.output, "--on", "slurm",
      fmt::format("--jobs={}", n_tasks)};
  for (const std::string& option : options.sbatch) collector.push_back("--sbatch=" + option);
  const campaign::SlurmJobs submitted = campaign::submit(jobs, {.folder = options.output + ".chunks/slurm",
                                                                .name = "brash-database",
                                                                .program = campaign::this_program(),
                                                                .n_tasks = n_tasks,
                                                                .sbatch = options.sbatch,
                                                                .collector = collector});
  print("{} chunks submitted as Slurm's jobs {} and {}\n", jobs.size(), submitted.array, submitted.collector);
}

/// The folder of the chunks, this process's alone; removed when it is empty in the end, unless it was somebody's empty
/// folder before.
class ChunkFolder {
 public:
  explicit ChunkFolder(const std::string& path)
      : path_(path), was_empty_(is_empty(path)), lock_(FolderLock::take_or_refuse(path, "lock")) {}
  ~ChunkFolder() {
    lock_.reset();
    std::error_code has_content;
    if (!was_empty_) std::filesystem::remove(path_, has_content);
  }
  ChunkFolder(const ChunkFolder&) = delete;
  ChunkFolder& operator=(const ChunkFolder&) = delete;

 private:
  static bool is_empty(const std::string& path) {
    std::error_code is_not_there;
    return std::filesystem::is_empty(path, is_not_there) && !is_not_there;
  }

  std::string path_;
  bool was_empty_;
  std::optional<FolderLock> lock_;
};

template <typename Plan>
void compute_plan(const Plan& plan, DatabaseOptions options) {
  io::refuse_missing_folder(options.output);
  refuse_overwriting(options.output, {options.plan});
  io::refuse_replacing_results(options.output);
  if (options.chunk >= 0) return training::solve_chunk(plan, options.output, options.chunk);
  const ChunkFolder folder(options.output + ".chunks");
  if (options.on == "slurm") {
    // The tasks run in folders of their own choice.
    for (std::string* const path : {&options.plan, &options.output})
      *path = std::filesystem::absolute(*path).lexically_normal().string();
    const std::vector<campaign::Job> jobs = missing_jobs(plan, options);
    if (!jobs.empty()) return submit_chunks(jobs, options);
  } else if (options.n_jobs > 1) {
    solve_in_processes(missing_jobs(plan, options), options.n_jobs);
  }
  build_here(plan, options.output);
}

void compute_database(const DatabaseOptions& options) {
  if (training::is_edge_plan(options.plan))
    compute_plan(training::read_edge_plan(options.plan), options);
  else
    compute_plan(training::read_plan(options.plan), options);
}

}  // namespace

void add_database_command(CLI::App& failure) {
  auto options = std::make_shared<DatabaseOptions>();
  CLI::App* command = failure.add_subcommand("database", "Solve the plate problem over a design of experiments");
  command->add_option("plan", options->plan, "plan (TOML)")->required();
  command->add_option("-o,--output", options->output, "database to write (netCDF)")->required();
  command->add_option("--on", options->on, "where it is computed")
      ->check(CLI::IsMember({"local", "slurm"}))
      ->capture_default_str();
  command->add_option("--jobs", options->n_jobs, "processes at once [1]; under Slurm, tasks of the array [100]")
      ->check(CLI::Range(1, 100000));
  command->add_option("--sbatch", options->sbatch, "an option for Slurm's sbatch")->take_all()->allow_extra_args(false);
  command->add_option("--chunk", options->chunk)->group("");  // not shown: the processes of --jobs have it
  command->footer(
      "A stopped or killed build continues when the same command is given again.\n"
      "Example: brash failure database experiments/failure_database/plan.toml -o cone.nc --jobs 2");
  command->callback([options] { compute_database(*options); });
}

}  // namespace brash::cli
