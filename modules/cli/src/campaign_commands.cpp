// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <thread>

#include "brash/advice/advice.hpp"
#include "brash/analysis/summary_tables.hpp"
#include "brash/campaign/campaign.hpp"
#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"
#include "brash/io/campaign_plan.hpp"
#include "brash/report/report.hpp"
#include "commands.hpp"
#include "messages.hpp"
#include "runs.hpp"

namespace brash::cli {
namespace {

using campaign::Counts;

struct CampaignOptions {
  std::string plan_file;
  std::string directory;
  std::vector<std::string> overrides;
  int n_jobs = 0;  ///< 0: not given
  std::optional<int> replicates;
  std::string on = "local";
  std::vector<std::string> sbatch;
  bool wait = false;
  bool status = false;
  bool resume = false;
  bool tables = false;
  bool quick = false;
  bool json = false;
};

std::string counts_text(const Counts& counts) {
  return fmt::format("{} of {} cases done, {} failed, {} missing", counts.n_done, counts.n_cases, counts.n_failed,
                     counts.n_missing());
}

void print_status(const Counts& counts, bool as_json) {
  if (as_json) {
    const nlohmann::ordered_json json{{"n_cases", counts.n_cases},
                                      {"n_done", counts.n_done},
                                      {"n_failed", counts.n_failed},
                                      {"n_missing", counts.n_missing()}};
    print_data(json.dump(2) + "\n");
  } else {
    print("{}\n", counts_text(counts));
  }
}

/// A line with the time left: on a terminal renewed, in a log a new one for each case that ends.
class CampaignProgress {
 public:
  ~CampaignProgress() {
    if (on_terminal_) cli::show("\r\033[K");
  }
  void show(const Counts& counts, std::size_t n_running) {
    using std::chrono::steady_clock;
    const int finished = counts.n_done + counts.n_failed;
    if (first_finished_ < 0) first_finished_ = last_finished_ = finished;
    if (!on_terminal_ && finished == last_finished_) return;
    last_finished_ = finished;
    const double wall = std::chrono::duration<double>(steady_clock::now() - start_).count();
    std::string line = fmt::format("{}, {} running", counts_text(counts), n_running);
    if (finished > first_finished_)
      line += fmt::format(", {:.0f} s left", wall * counts.n_missing() / (finished - first_finished_));
    cli::show(on_terminal_ ? "\r\033[K" + line : line + "\n");
  }

 private:
  bool on_terminal_ = isatty(STDERR_FILENO) != 0;
  int first_finished_ = -1, last_finished_ = -1;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Whether the tables are of the cases that there are now: a collector may have been killed before it wrote them again.
bool is_up_to_date(const std::string& summary_file, const Counts& counts) {
  if (!std::filesystem::exists(summary_file)) return false;
  const auto summary = nlohmann::json::parse(read_json_text(summary_file, "the summary of a campaign"), nullptr, false);
  const auto states = [&](const char* key, int n) { return summary.value(key, nlohmann::json()) == n; };
  return summary.is_object() && states("n_cases", counts.n_cases) && states("n_done", counts.n_done) &&
         states("n_failed", counts.n_failed);
}

Counts run_here(const campaign::Campaign& campaign, int n_jobs) {
  CampaignProgress progress;
  const int n_workers = n_jobs > 0 ? n_jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return campaign::run_local(campaign, n_workers,
                             [&](const Counts& now, std::size_t n_running) { progress.show(now, n_running); });
}

/// This command as a collector gives it again.
std::vector<std::string> collector_command(const campaign::Campaign& campaign, const CampaignOptions& options) {
  std::vector<std::string> command{campaign.program, "campaign", campaign.plan_file, "-o", campaign.directory,
                                   "--on",           "slurm",    "--resume"};
  const auto add = [&](const char* option, const std::string& value) {
    command.push_back(fmt::format("{}={}", option, value));
  };
  if (options.quick) command.push_back("--quick");
  if (options.n_jobs > 0) add("--jobs", std::to_string(options.n_jobs));
  if (options.replicates) add("--replicates", std::to_string(*options.replicates));
  for (const std::string& text : options.overrides) add("--set", text);
  for (const std::string& text : options.sbatch) add("--sbatch", text);
  return command;
}

/// Waits until nothing of the campaign is in the queue. @return the counts then.
Counts wait_for_slurm(const campaign::Campaign& campaign) {
  CampaignProgress progress;
  const std::string folder = campaign::slurm_folder(campaign.directory);
  while (campaign::is_in_queue(folder)) {
    progress.show(campaign::count(campaign.plan, campaign.directory), 0);
    std::this_thread::sleep_for(std::chrono::seconds(1));
  }
  return campaign::count(campaign.plan, campaign.directory);
}

Counts run_under_slurm(campaign::Campaign& campaign, const CampaignOptions& options) {
  // The jobs run in folders of their own choice.
  campaign.directory = std::filesystem::absolute(campaign.directory).lexically_normal().string();
  campaign.plan_file = std::filesystem::absolute(campaign.plan_file).lexically_normal().string();
  constexpr int kTasks = 100;
  const Counts counts = campaign::run_slurm(campaign, {.folder = {},
                                                       .name = {},
                                                       .program = {},
                                                       .n_tasks = options.n_jobs > 0 ? options.n_jobs : kTasks,
                                                       .sbatch = options.sbatch,
                                                       .collector = collector_command(campaign, options)});
  return options.wait ? wait_for_slurm(campaign) : counts;
}

/// Says when more than one program made the cases, as after an upgrade between two calls.
void say_programs(const std::string& manifest_file) {
  const auto manifest =
      nlohmann::json::parse(read_json_text(manifest_file, "the manifest of a campaign"), nullptr, false);
  std::map<std::string, int> cases;  // of each program
  for (const auto& maker : manifest.value("cases_made_by", nlohmann::json::array()))
    cases[maker.at("program").dump()] += maker.at("n_cases").get<int>();
  if (cases.size() < 2) return;
  std::vector<int> numbers;
  for (const auto& [program, n] : cases) numbers.push_back(n);
  say("warning: {} programs made the cases ({}), and their results may differ: {} names them under cases_made_by\n",
      cases.size(), fmt::join(numbers, " and "), manifest_file);
}

/// Names the settings with replicates that coincide.
void say_repeated(const std::string& summary_file) {
  const auto summary = nlohmann::ordered_json::parse(read_json_text(summary_file, "the summary of a campaign"));
  std::vector<std::string> names;
  for (const auto& setting : summary.at("settings"))
    if (const int n = analysis::n_repeated(setting); n > 0)
      names.push_back(fmt::format("{} of {} in {}", n, setting.at("n_done").get<int>(),
                                  printable(setting.at("setting").get<std::string>())));
  if (names.empty()) return;
  say("warning: {}: replicates have the numbers of an earlier one to the last digit, and count once: {}; too little of "
      "these cases is random: vary the ice with ice.variation.thickness and ice.variation.flexural_strength\n",
      io::kRepeated, fmt::join(names, ", "));
}

/// The command as it was given, for the reader to give it again.
std::string command_of(const CampaignOptions& options) {
  std::string command = fmt::format("brash campaign {} -o {}", options.plan_file, options.directory);
  if (options.quick) command += " --quick";
  for (const std::string& text : options.overrides) command += fmt::format(" --set '{}'", text);
  return command;
}

/// Prints the tables of a campaign and makes its page. `told` are the warnings that were printed before the cases ran.
void show_results(const campaign::Campaign& campaign, const CampaignOptions& options, const Counts& counts,
                  const std::set<std::string>& told) {
  if (!options.json)
    print("{}\n", analysis::means_table(campaign.directory + "/summary.json", command_of(options), told));
  print_status(counts, options.json);
  if (!options.json) print("results in {}\n", options.directory);
  const std::string page = report::has_page() ? report::write_report(options.directory) : "";
  if (!options.json && !page.empty()) print("report in  {}\n", page);
  if (const int n = campaign::count_beyond(campaign.plan, campaign.directory); n > 0)
    say("warning: {}/cases has {} done cases that the plan does not have now: no table counts them\n",
        options.directory, n);
  say_programs(campaign.directory + "/manifest.json");
  say_repeated(campaign.directory + "/summary.json");
  if (counts.n_failed > 0)
    throw RunError(fmt::format("{} cases failed; {}/cases/*.failed say why", counts.n_failed, options.directory));
}

/// The warnings about a case; none about one of which nothing can be derived: it reports why when it runs.
std::vector<model::Warning> warnings_about(const model::Case& resolved) {
  try {
    return advice::warnings_of(resolved);
  } catch (const std::exception&) {
    return {};
  }
}

/// At most so many settings are looked at before a campaign: one takes about a tenth of a second.
constexpr std::size_t kMostLookedAt = 32;

/// All settings, or kMostLookedAt settings spread from the first to the last.
std::vector<const io::Setting*> some_of(const std::vector<io::Setting>& settings) {
  const std::size_t n = std::min(settings.size(), kMostLookedAt);
  std::vector<const io::Setting*> some;
  for (std::size_t i = 0; i < n; ++i)
    some.push_back(&settings[n < settings.size() ? i * (settings.size() - 1) / (n - 1) : i]);
  return some;
}

/// Says the warnings about the settings, each once: the text is of the first setting that has it. @return their ids.
std::set<std::string> say_warnings_of_settings(const std::vector<io::Setting>& all_settings) {
  struct Told {
    model::Warning warning;
    std::string setting;
    int n_settings = 0;
  };
  std::vector<Told> all;
  const std::vector<const io::Setting*> settings = some_of(all_settings);
  for (const io::Setting* const setting : settings) {
    std::set<std::string> counted;
    for (model::Warning& warning : warnings_about(setting->resolved)) {
      if (!counted.insert(warning.id).second) continue;
      const auto told = std::ranges::find(all, warning.id, [](const Told& t) { return t.warning.id; });
      if (told == all.end())
        all.push_back({.warning = std::move(warning), .setting = setting->name, .n_settings = 1});
      else
        ++told->n_settings;
    }
  }
  std::set<std::string> told;
  for (const auto& [warning, setting, n] : all) {
    const char* const looked_at = settings.size() < all_settings.size() ? " that were looked at" : "";
    const std::string whose =
        settings.size() > 1 ? fmt::format("{} of {} settings{}, such as {}: ", n, settings.size(), looked_at, setting)
                            : "";
    say("warning: {}: {}{}\n", warning.id, whose, warning.text);
    told.insert(warning.id);
  }
  return told;
}

/// Refuses the options of Slurm on this machine, where they would have no effect.
void refuse_options_of_slurm(const CampaignOptions& options) {
  if (options.on == "slurm" || (options.sbatch.empty() && !options.wait)) return;
  throw InputError(Complaint{options.wait ? "--wait" : "--sbatch",
                             fmt::format("has no effect with --on {}", options.on), "--on slurm",
                             "add `--on slurm`, or leave the option out"});
}

campaign::Campaign campaign_of(const CampaignOptions& options) {
  return {.plan = io::read_campaign_plan(options.plan_file, {.quick = options.quick,
                                                             .replicates = options.replicates,
                                                             .overrides = options.overrides,
                                                             .known_columns = campaign::known_columns(),
                                                             .default_columns = campaign::default_columns()}),
          .plan_file = options.plan_file,
          .directory = options.directory,
          .resume = options.resume || options.tables,
          .program = campaign::this_program(),
          .unfit = [](const std::string& what) { say("warning: {}: the case is run again\n", what); }};
}

void refuse_missing(const campaign::Campaign& campaign, const Counts& counts) {
  if (counts.n_missing() > 0 || !is_up_to_date(campaign.directory + "/summary.json", counts))
    throw Interrupted(fmt::format("stopped with {}; the same command with `--resume` continues", counts_text(counts)));
}

void run_campaign(const CampaignOptions& options) {
  refuse_options_of_slurm(options);
  campaign::Campaign campaign = campaign_of(options);
  const Counts before = campaign::count(campaign.plan, options.directory);
  // Later on the table shows the warnings.
  std::set<std::string> told;
  if (!options.tables && before.n_done + before.n_failed == 0) told = say_warnings_of_settings(campaign.plan.settings);
  if (options.status) return print_status(before, options.json);
  if (options.tables) {
    show_results(campaign, options, campaign::write_tables(campaign), told);
    return;
  }
  const bool here = options.on == "local";
  const Counts counts = here ? run_here(campaign, options.n_jobs) : run_under_slurm(campaign, options);
  if (counts.n_missing() > 0 && !here && !options.wait) {
    if (!options.json) return print("{}; submitted, see squeue; `--status` counts\n", counts_text(counts));
    print_status(counts, options.json);
    return say("submitted, see squeue; `--status` counts\n");
  }
  refuse_missing(campaign, counts);
  show_results(campaign, options, counts, told);
}

void run_one_case(const campaign::CaseTask& task) {
  // Without the process that started it, nobody would look at its results.
  const pid_t parent = ::getppid();
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) std::raise(SIGTERM);
  catch_requests_to_end();
  try {
    if (campaign::run_case(task, is_asked_to_end) == campaign::CaseEnd::kInterrupted) throw Interrupted("interrupted");
  } catch (const StorageError& error) {
    throw CaseNotStored(error.what());
  } catch (const std::bad_alloc&) {
    throw CaseNotStored(task.folder + ": there is not enough memory for the case\n  remedy:  fewer --jobs at once");
  }
}

/// The number of a Slurm task.
std::size_t number_of(const std::string& task) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(task.data(), task.data() + task.size(), number);
  if (error != std::errc{} || end != task.data() + task.size())
    throw InputError("campaign-chunk: SLURM_ARRAY_TASK_ID is not a number");
  return number;
}

void add_chunk_command(CLI::App& app) {
  auto list_file = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("campaign-chunk", "Run the part of a list of jobs that a Slurm task has");
  command->group("");  // not shown: Slurm's tasks start it
  command->add_option("list", *list_file)->required();
  command->callback([list_file] {
    const char* const task = std::getenv("SLURM_ARRAY_TASK_ID");
    if (task == nullptr) throw InputError("campaign-chunk: is run by the tasks of a Slurm array");
    if (!campaign::run_chunk(*list_file, number_of(task))) throw Interrupted("interrupted");
  });
}

void add_case_command(CLI::App& app) {
  auto task = std::make_shared<campaign::CaseTask>();
  CLI::App* command = app.add_subcommand("campaign-case", "Run one case of a campaign");
  command->group("");  // not shown: campaigns start it
  command->add_option("case", task->case_file)->required();
  command->add_option("folder", task->folder)->required();
  command->add_option("--replicate", task->replicate)->required();
  command->add_option("--keep", task->keep)->required();
  command->callback([task] { run_one_case(*task); });
}

}  // namespace

void run_plan(const PlanRun& run) {
  CampaignOptions options;
  options.plan_file = run.plan_file;
  options.directory = run.directory;
  options.overrides = run.overrides;
  options.n_jobs = run.n_jobs;
  options.resume = run.resume;
  const campaign::Campaign campaign = campaign_of(options);
  if (const Counts before = campaign::count(campaign.plan, run.directory); before.n_done + before.n_failed == 0)
    say_warnings_of_settings(campaign.plan.settings);
  const Counts counts = run_here(campaign, run.n_jobs);
  refuse_missing(campaign, counts);
  say_programs(run.directory + "/manifest.json");
  if (counts.n_failed > 0)
    say("warning: {} of {} cases failed; {}/cases/*.failed say why\n", counts.n_failed, counts.n_cases, run.directory);
}

void add_campaign_commands(CLI::App& app) {
  auto options = std::make_shared<CampaignOptions>();
  CLI::App* command = app.add_subcommand("campaign", "Run a case over a grid of settings, with replicates");
  command->add_option("plan", options->plan_file, "plan (TOML)")->required();
  command->add_option("-o,--output", options->directory, "folder of the results")->required();
  command->add_option("--on", options->on, "where the cases run")
      ->check(CLI::IsMember({"local", "slurm"}))
      ->capture_default_str();
  command
      ->add_option("--jobs", options->n_jobs,
                   "cases at once [as many as there are cores]; under Slurm, tasks of the array [100]")
      ->check(CLI::Range(1, 100000));
  command->add_option("--sbatch", options->sbatch, "an option for Slurm's sbatch, as in --sbatch=--partition=short")
      ->take_all()
      ->allow_extra_args(false);
  command->add_flag("--wait", options->wait, "under Slurm, stay until it is over");
  auto* const status =
      command->add_flag("--status", options->status, "count the cases done, failed and missing; run nothing");
  command->add_flag("--tables", options->tables, "make the tables of the cases that are done; run nothing")
      ->excludes(status);
  command->add_flag("--resume", options->resume, "continue with what the folder holds");
  command->add_flag("--quick", options->quick, "the small variant that the plan's [quick] describes");
  command
      ->add_option("--replicates", options->replicates,
                   "replicates of each setting, in place of the plan's number and its stop rule")
      ->check(CLI::Range(1, 100000));
  command->add_option("--set", options->overrides, "section.key=value, for every case")
      ->take_all()
      ->allow_extra_args(false);
  command->add_flag("--json", options->json, "the counts as JSON");
  command->footer("Example: brash campaign experiments/velocity/plan.toml -o results/velocity --jobs 2");
  command->callback([options] { run_campaign(*options); });
  add_case_command(app);
  add_chunk_command(app);
}

}  // namespace brash::cli
