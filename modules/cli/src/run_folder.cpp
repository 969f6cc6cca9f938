// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_folder.hpp"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/write_file.hpp"
#include "brash/recording/recording.hpp"
#include "brash/report/plan_view.hpp"
#include "brash/report/report.hpp"
#include "brash/simulation/initial_floes.hpp"
#include "report_source.hpp"

namespace brash::cli {
namespace {

namespace fs = std::filesystem;

/// Whether a file is a checkpoint of some version, whole or not: a name proves nothing.
/// @throws InputError when it may not be read.
bool is_checkpoint(const fs::path& file) {
  if (::access(file.c_str(), R_OK) != 0)
    throw InputError(Complaint{file.string(), "cannot be opened: " + std::generic_category().message(errno),
                               "a folder that is new, empty or of a run", "check its permissions"});
  try {
    constexpr std::size_t kMostMebibytes = 8192;
    return read_text_file(file.string(), "a checkpoint", kMostMebibytes).find("brash-checkpoint-") != std::string::npos;
  } catch (const InputError&) {
    return false;
  }
}

/// Whether a file is the manifest of a run of some version.
bool is_manifest(const fs::path& file) {
  try {
    const auto manifest = nlohmann::json::parse(read_json_text(file.string(), "a manifest"), nullptr, false);
    return manifest.is_object() && manifest.value("format", nlohmann::json()).is_string() &&
           manifest["format"].get<std::string>().starts_with("brash-manifest-");
  } catch (const InputError&) {
    return false;
  }
}

/// A run replaces the files of an earlier run, and nothing else. A folder has no place under the name of a file.
void refuse_files_of_others(const fs::path& directory) {
  constexpr std::array kNames{"history.csv", "events.csv", "summary.json", "manifest.json",
                              "run.nc",      "plan.svg",   "report.html",  "checkpoint.nc"};
  std::error_code ignored;
  const auto refuse = [&](const char* name, const char* what) {
    throw InputError(Complaint{(directory / name).string(), what, "a folder that is new, empty or of a run",
                               "give another folder, or move the file"});
  };
  for (const char* const name : kNames)
    if (fs::is_directory(directory / name, ignored)) refuse(name, "is a folder, and a run writes a file of this name");
  const auto has = [&](const char* name) { return fs::exists(fs::symlink_status(directory / name, ignored)); };
  const bool has_checkpoint = has("checkpoint.nc") && is_checkpoint(directory / "checkpoint.nc");
  if (has("checkpoint.nc") && !has_checkpoint)
    refuse("checkpoint.nc", "is there, but no run left it, and a run would replace it");
  if (has_checkpoint || (has("summary.json") && is_manifest(directory / "manifest.json"))) return;
  for (const char* const name : kNames)
    if (has(name)) refuse(name, "is there, but no run left it, and a run would replace it");
  if (has("inputs")) refuse("inputs", "is there, but no run left it, and a run would write into it");
}

/// The campaign that has `directory` for the folder of a case, begun or done; empty: there is none.
fs::path campaign_around(const std::string& directory) {
  std::error_code ignored;
  fs::path folder = fs::weakly_canonical(fs::absolute(directory), ignored);
  if (!folder.has_filename()) folder = folder.parent_path();
  const fs::path cases = folder.parent_path(), around = cases.parent_path();
  if (cases.filename() != "cases") return {};
  const bool begun = fs::is_directory(around / "settings", ignored) && fs::is_directory(around / "inputs", ignored);
  return begun || report::is_campaign(around.string()) ? around : fs::path();
}

}  // namespace

FolderLock open_run_folder(const std::string& directory) {
  if (report::is_campaign(directory))
    throw InputError(Complaint{directory, "holds a campaign, of whose files some have the names of a run's",
                               "a folder that is new, empty or of a run", "give another folder"});
  if (const fs::path campaign = campaign_around(directory); !campaign.empty())
    throw InputError(
        Complaint{directory, "belongs to the cases of the campaign in " + campaign.string(),
                  "a folder that is new, empty or of a run, outside of a campaign",
                  "give another folder; `brash campaign --resume` computes a case whose folder you remove"});
  FolderLock lock = FolderLock::take_or_refuse(directory, "run.lock");
  refuse_files_of_others(directory);
  remove_parts(directory);
  return lock;
}

void refuse_replacing(const std::string& directory, const std::string& other_remedy) {
  const auto refuse = [&](const char* what, const std::string& remedy) {
    throw InputError(Complaint{directory, what, "a folder without results of a run", remedy + other_remedy});
  };
  const fs::path folder(directory);
  if (fs::exists(folder / "manifest.json") && fs::exists(folder / "summary.json"))
    refuse("holds a finished run, which a new run would replace", "give another folder");
  if (fs::exists(folder / "checkpoint.nc"))
    refuse("holds an interrupted run, which a new run would replace",
           "go on from its checkpoint with `brash run --resume`, or give another folder");
}

void remove_run(const std::string& directory) {
  recording::remove_results(directory);
  for (const char* const name : {"report.html", "plan.svg"}) fs::remove(fs::path(directory) / name);
}

void write_run_folder(const std::string& directory, const recording::Inputs& inputs, const simulation::Run& run) {
  write_file(directory + "/plan.svg",
             report::plan_view(inputs.resolved, run.results, simulation::land_outlines(inputs.resolved)));
  recording::write_run(directory, inputs, run, {"plan.svg"});
  if (report::has_page()) write_report(directory);
}

void expect_manifest(const std::string& directory) {
  if (!fs::exists(fs::path(directory) / "manifest.json"))
    throw InputError(Complaint{directory, fs::is_directory(directory) ? "holds no manifest.json" : "is no folder",
                               "the folder of a run or a campaign",
                               "give the folder that `brash run` or `brash campaign` wrote"});
}

std::string write_report(const std::string& directory) {
  expect_manifest(directory);
  if (!report::is_campaign(directory)) return report::write_run_report(report_source(directory));
  std::error_code no_cases;
  for (const auto& entry : fs::directory_iterator(directory + "/cases", no_cases))
    if (!entry.is_symlink() && fs::exists(entry.path() / "run.nc"))
      report::write_run_report(report_source(entry.path().string()));
  return report::write_campaign_report(directory);
}

}  // namespace brash::cli
