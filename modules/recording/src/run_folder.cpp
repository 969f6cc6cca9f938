// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/recording/run_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>
#include <vector>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/write_file.hpp"
#include "brash/io/run_summary.hpp"
#include "brash/recording/recording.hpp"

namespace brash::recording {
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

/// Where the results of a run lie until they are whole, and the file in it that says whose they are.
constexpr const char* kNewResults = "results.part";
constexpr const char* kRunMark = "run.begun";

/// Whether a folder is of results that are not whole: it has the mark, or a run died before that was whole.
bool is_of_new_results(const fs::path& part) {
  bool only_of_mark = true;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(part, ignored)) {
    const std::string name = entry.path().filename();
    if (name == kRunMark) return true;
    only_of_mark = only_of_mark && name.starts_with(kRunMark);
  }
  return only_of_mark;
}

/// The mark goes last: a run may die here too.
void remove_new_results(const fs::path& part) {
  std::error_code ignored;
  std::vector<fs::path> others;
  for (const auto& entry : fs::directory_iterator(part, ignored))
    if (entry.path().filename() != kRunMark) others.push_back(entry.path());
  for (const fs::path& other : others) fs::remove_all(other, ignored);
  fs::remove_all(part, ignored);
}

/// Gives the whole results in `part` their names in `directory`, in place of older ones. The manifest, which vouches
/// for the others, goes first and comes last: as long as the new one is in `part`, this can be done again.
void move_results(const fs::path& part, const fs::path& directory) {
  try {
    std::vector<fs::path> names;
    for (const auto& entry : fs::recursive_directory_iterator(part))
      if (const fs::path name = entry.path().lexically_relative(part); !entry.is_directory() && name != kRunMark)
        names.push_back(name);
    for (const char* const name : {"manifest.json", "report.html"}) fs::remove(directory / name);
    for (const fs::path& name : names) fs::remove(directory / name);
    std::partition(names.begin(), names.end(), [](const fs::path& name) { return name != "manifest.json"; });
    for (const fs::path& name : names) {
      fs::create_directories((directory / name).parent_path());
      fs::rename(part / name, directory / name);
    }
    remove_new_results(part);
  } catch (const fs::filesystem_error& error) {
    throw StorageError(
        fmt::format("{}: cannot be written: {}\n  remedy:  check that its folder may be written and has space",
                    error.path1().string(), error.code().message()));
  }
}

/// Settles the results that a killed run left: whole ones get their names, others go.
void settle_results(const fs::path& directory) {
  const fs::path part = directory / kNewResults;
  std::error_code ignored;
  const fs::file_status status = fs::symlink_status(part, ignored);
  if (!fs::exists(status)) return;
  if (!fs::is_directory(status) || !is_of_new_results(part))
    throw InputError(Complaint{part.string(), "is there, but no run left it, and a run would write into it",
                               "a folder that is new, empty or of a run", "give another folder, or move it"});
  if (is_manifest(part / "manifest.json")) return move_results(part, directory);
  remove_new_results(part);
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
  return begun || io::is_campaign(around.string()) ? around : fs::path();
}

}  // namespace

FolderLock open_run_folder(const std::string& directory) {
  if (io::is_campaign(directory))
    throw InputError(Complaint{directory, "holds a campaign, of whose files some have the names of a run's",
                               "a folder that is new, empty or of a run", "give another folder"});
  if (const fs::path campaign = campaign_around(directory); !campaign.empty())
    throw InputError(
        Complaint{directory, "belongs to the cases of the campaign in " + campaign.string(),
                  "a folder that is new, empty or of a run, outside of a campaign",
                  "give another folder; `brash campaign --resume` computes a case whose folder you remove"});
  FolderLock lock = FolderLock::take_or_refuse(directory, "run.lock");
  settle_results(directory);
  refuse_files_of_others(directory);
  remove_parts(directory);
  if (!fs::exists(directory + "/checkpoint.nc")) remove_checkpoint(directory + "/checkpoint.nc");
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
           "continue from its checkpoint with `brash run --resume`, or give another folder");
}

NewResults::~NewResults() {
  const fs::path part = fs::path(directory_) / kNewResults;
  std::error_code ignored;
  // Whole results whose names could not be given wait for the next command.
  if (!fs::exists(part / "manifest.json", ignored)) remove_new_results(part);
}

void NewResults::begin() const {
  write_file(directory_ + "/" + kNewResults + "/" + kRunMark, "The results of a run go here until they are whole.\n");
}

void NewResults::write(const Inputs& inputs, const simulation::Run& run, const std::vector<Picture>& pictures) const {
  const fs::path part = fs::path(directory_) / kNewResults;
  std::vector<std::string> names;
  for (const Picture& picture : pictures) {
    write_file((part / picture.name).string(), picture.bytes);
    names.push_back(picture.name);
  }
  write_run(part.string(), inputs, run, names);
  move_results(part, directory_);
  // Rows in files take as much space as the results, which are whole now.
  const std::string checkpoint = directory_ + "/checkpoint.nc";
  if (!files_of_rows(checkpoint).empty()) remove_checkpoint(checkpoint);
}

}  // namespace brash::recording
