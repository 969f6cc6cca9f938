// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_folder.hpp"

#include <filesystem>

#include "brash/core/error.hpp"
#include "brash/core/write_file.hpp"
#include "brash/recording/recording.hpp"
#include "brash/report/plan_view.hpp"
#include "brash/report/report.hpp"
#include "closed_forms.hpp"

namespace brash::cli {
namespace {

namespace fs = std::filesystem;

/// A run replaces what an earlier one left, and nothing else.
void refuse_files_of_others(const fs::path& directory) {
  const auto has = [&](const char* name) { return fs::exists(directory / name); };
  if (has("checkpoint.nc") || (has("manifest.json") && has("summary.json"))) return;
  for (const char* const name :
       {"history.csv", "events.csv", "summary.json", "manifest.json", "run.nc", "plan.svg", "report.html"})
    if (has(name))
      throw InputError(Complaint{(directory / name).string(),
                                 "is there, but no run left it, and a run would replace it",
                                 "a folder that is new, empty or of a run", "give another folder, or move the file"});
}

}  // namespace

FolderLock open_run_folder(const std::string& directory) {
  if (report::is_campaign(directory))
    throw InputError(Complaint{directory, "holds a campaign, of whose files some have the names of a run's",
                               "a folder that is new, empty or of a run", "give another folder"});
  FolderLock lock = FolderLock::take_or_refuse(directory, "run.lock");
  refuse_files_of_others(directory);
  remove_parts(directory);
  return lock;
}

void remove_run(const std::string& directory) {
  recording::remove_results(directory);
  for (const char* const name : {"report.html", "plan.svg"}) fs::remove(fs::path(directory) / name);
}

void write_run_folder(const std::string& directory, const std::string& case_file, const model::Case& resolved,
                      const simulation::Run& run) {
  write_file(directory + "/plan.svg", report::plan_view(resolved, run.results));
  recording::write_run(directory, case_file, resolved, run, {"plan.svg"});
  if (report::has_page()) write_report(directory);
}

std::string write_report(const std::string& directory) {
  const auto report_run = [](const std::string& folder) {
    return report::write_run_report(folder, closed_form_loads(report::case_of_run(folder)).dump());
  };
  if (!report::is_campaign(directory)) return report_run(directory);
  std::error_code no_cases;
  for (const auto& entry : fs::directory_iterator(directory + "/cases", no_cases))
    if (fs::exists(entry.path() / "run.nc")) report_run(entry.path().string());
  return report::write_campaign_report(directory);
}

}  // namespace brash::cli
