// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/campaign/slurm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "brash/campaign/subprocess.hpp"
#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/write_file.hpp"
#include "brash/io/results.hpp"
#include "folder.hpp"

namespace brash::campaign {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Rounds without progress after which a collector does not submit again.
constexpr int kMostIdleRounds = 3;
/// How long a controller may be away before a command to it has failed [s].
constexpr int kPatience = 120;

/// Runs its arguments as a command: the words of a command come as arguments, so a shell reads none of these words.
constexpr const char* kScript = "#!/bin/sh\nexec \"$@\"\n";

/// The number of the Slurm job that this process is part of; "" when it is not part of one.
std::string own_job() {
  const char* const job = std::getenv("SLURM_JOB_ID");
  return job == nullptr ? "" : job;
}

/// Runs a command of Slurm; waits for a controller that is away.
Printed ask_slurm(const std::vector<std::string>& command) {
  for (int waited = 0;; ++waited) {
    Printed printed = run_command(command);
    const bool away = printed.code != 0 && (printed.err.find("contact slurm controller") != std::string::npos ||
                                            printed.err.find("Socket timed out") != std::string::npos);
    if (!away || waited >= kPatience) return printed;
    std::this_thread::sleep_for(std::chrono::seconds(1));
  }
}

std::string trimmed(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text;
}

/// Submits a job. @return its number.
std::string sbatch(const SlurmOptions& options, const std::vector<std::string>& own,
                   const std::vector<std::string>& command) {
  std::vector<std::string> all{
      "sbatch", "--parsable", "--requeue", "--open-mode=append", "--ntasks=1", "--job-name=" + options.name};
  all.insert(all.end(), own.begin(), own.end());
  all.insert(all.end(), options.sbatch.begin(), options.sbatch.end());
  all.push_back(options.folder + "/exec.sh");
  all.insert(all.end(), command.begin(), command.end());
  const Printed printed = ask_slurm(all);
  if (printed.code != 0)
    throw RunError(
        fmt::format("sbatch refused: {}\n  remedy:  give it what it misses with --sbatch, as in --sbatch "
                    "--partition=short",
                    trimmed(printed.err)));
  // "number" or "number;cluster"
  const std::string job = trimmed(printed.out);
  return job.substr(0, job.find(';'));
}

/// An option that sends the output of a job into `folder`; % begins Slurm's own patterns.
std::string output_option(const std::string& folder, const char* pattern) {
  std::string option = "--output=";
  for (const char c : folder) option += c == '%' ? "%%" : std::string(1, c);
  return option + "/" + pattern;
}

Json json_of(const Job& job) {
  return {{"command", job.command},
          {"messages", job.messages},
          {"folder", job.folder},
          {"result", job.result},
          {"record", job.record}};
}

/// The jobs in `n` parts, consecutive ones together, none empty.
Json parts(const std::vector<Job>& jobs, std::size_t n) {
  Json all = Json::array();
  for (std::size_t part = 0; part < n; ++part) {
    Json list = Json::array();
    for (std::size_t i = part * jobs.size() / n; i < (part + 1) * jobs.size() / n; ++i)
      list.push_back(json_of(jobs[i]));
    all.push_back(std::move(list));
  }
  return all;
}

/// The submissions so far, oldest first; empty when there were none.
Json read_rounds(const std::string& folder) {
  const std::string path = folder + "/submitted.json";
  if (!fs::exists(path)) return Json::array();
  const Json rounds = Json::parse(read_json_text(path, "what was submitted to Slurm"), nullptr, false);
  const auto is_round = [](const Json& round) {
    return round.is_object() && round.value("array", Json()).is_string() &&
           round.value("collector", Json()).is_string() && round.value("n_jobs", Json()).is_number_unsigned() &&
           round.value("idle_rounds", Json()).is_number_unsigned();
  };
  if (!rounds.is_array() || !std::ranges::all_of(rounds, is_round))
    throw InputError(Complaint{path, "is not a list of what was submitted", "the file that brash wrote",
                               "`scancel` what is left of this campaign, and remove the file"});
  return rounds;
}

/// The file that lists the jobs of a round, counted from 1.
std::string list_of_round(const std::string& folder, std::size_t round) {
  return fmt::format("{}/round-{}.json", folder, round);
}

/// The jobs of each part, as `parts` wrote them.
std::vector<std::vector<Job>> read_list(const std::string& list_file) {
  const Json list = Json::parse(read_json_text(list_file, "a list of jobs"), nullptr, /*allow_exceptions=*/false);
  std::vector<std::vector<Job>> all;
  try {
    if (!list.is_array()) throw InputError(fmt::format("{}: is not a list of jobs", list_file));
    for (const Json& part : list) {
      all.emplace_back();
      for (const Json& job : part)
        all.back().push_back(
            {0, job.at("command"), job.at("messages"), job.at("folder"), job.at("result"), job.at("record")});
    }
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("{}: is not a list of jobs: {}", list_file, error.what()));
  }
  return all;
}

/// In a collector: how many rounds in a row ended no job, neither done nor failed on its own, this time included. The
/// number of jobs alone does not show this: a stop rule adds others.
int idle_rounds(const std::string& folder, const Json& rounds) {
  if (rounds.empty() || rounds.back().at("collector") != own_job()) return 0;
  for (const std::vector<Job>& part : read_list(list_of_round(folder, rounds.size())))
    if (std::ranges::any_of(part, is_over)) return 0;
  return rounds.back().at("idle_rounds").get<int>() + 1;
}

bool is_job_in_queue(const std::string& job) {
  if (job == own_job()) return false;
  const Printed printed = ask_slurm({"squeue", "--noheader", "--format=%i", "--jobs=" + job});
  // The controller forgets old jobs.
  if (printed.code != 0 && printed.err.find("Invalid job id") != std::string::npos) return false;
  if (printed.code != 0) throw RunError("squeue cannot list the queue: " + trimmed(printed.err));
  return !trimmed(printed.out).empty();
}

}  // namespace

SlurmJobs submit(const std::vector<Job>& jobs, const SlurmOptions& options) {
  if (is_in_queue(options.folder))
    throw InputError(
        fmt::format("{}: what was submitted from it is still in the queue\n  remedy:  wait until it is over, "
                    "or `scancel` it",
                    options.folder));
  Json rounds = read_rounds(options.folder);
  const int idle = idle_rounds(options.folder, rounds);
  if (idle >= kMostIdleRounds)
    throw RunError(
        fmt::format("{} rounds under Slurm in a row ended without a job that was done; see {}", idle, options.folder));

  write_file(options.folder + "/exec.sh", kScript);
  const std::string list_file = list_of_round(options.folder, rounds.size() + 1);
  const std::size_t n_tasks = std::min(jobs.size(), static_cast<std::size_t>(options.n_tasks));
  write_file(list_file, parts(jobs, n_tasks).dump(1) + "\n");
  SlurmJobs submitted;
  submitted.array =
      sbatch(options, {fmt::format("--array=0-{}", n_tasks - 1), output_option(options.folder, "%A_%a.txt")},
             {options.program, "campaign-chunk", list_file});
  try {
    submitted.collector =
        sbatch(options, {"--dependency=afterany:" + submitted.array, output_option(options.folder, "%j.txt")},
               options.collector);
  } catch (const std::exception& error) {
    // Nobody would collect what it computes, and a next call would submit it again.
    const bool cancelled = ask_slurm({"scancel", submitted.array}).code == 0;
    throw RunError(fmt::format("{}\n  the array {} {}", error.what(), submitted.array,
                               cancelled ? "was cancelled" : "is still in the queue: `scancel` it"));
  }
  rounds.push_back(
      {{"array", submitted.array}, {"collector", submitted.collector}, {"n_jobs", jobs.size()}, {"idle_rounds", idle}});
  write_file(options.folder + "/submitted.json", rounds.dump(2) + "\n");
  return submitted;
}

bool is_in_queue(const std::string& folder) {
  for (Json rounds = read_rounds(folder); !rounds.empty();) {
    const Json& last = rounds.back();
    if (is_job_in_queue(last.at("array")) || is_job_in_queue(last.at("collector"))) return true;
    // A collector may have submitted again and ended since the rounds were read.
    Json now = read_rounds(folder);
    if (now == rounds) return false;
    rounds = std::move(now);
  }
  return false;
}

bool run_chunk(const std::string& list_file, std::size_t chunk) {
  const std::vector<std::vector<Job>> list = read_list(list_file);
  if (chunk >= list.size()) throw InputError(fmt::format("{}: has no part {} of a list of jobs", list_file, chunk));
  return run_jobs(1, list[chunk]);
}

}  // namespace brash::campaign
