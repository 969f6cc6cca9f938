// SPDX-License-Identifier: GPL-3.0-or-later
#include "folder.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "brash/campaign/campaign.hpp"
#include "brash/core/error.hpp"
#include "brash/core/folder_lock.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/write_file.hpp"
#include "brash/io/results.hpp"
#include "brash/recording/inputs.hpp"
#include "case_results.hpp"

namespace brash::campaign {

namespace fs = std::filesystem;

std::string read_text(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return {};
  try {
    return read_text_file(path.string(), "a file of a campaign");
  } catch (const InputError&) {
    return {};
  }
}

namespace {

[[noreturn]] void refuse_folder(const std::string& path, const std::string& what) {
  throw InputError(Complaint{path, what, "a folder that is new, empty or of this campaign", "give another folder"});
}

/// Whether the manifest in `directory` is a campaign's; nothing when there is none.
std::optional<bool> has_campaign_manifest(const std::string& directory) {
  const std::string path = directory + "/manifest.json";
  if (!fs::exists(fs::symlink_status(path))) return {};
  try {
    const auto manifest = nlohmann::json::parse(read_json_text(path, "a manifest"), nullptr, false);
    return manifest.is_object() && manifest.contains("format") && manifest["format"] == kManifestFormat;
  } catch (const InputError&) {
    return false;
  }
}

/// Nothing that is written or removed may lie elsewhere.
void refuse_links(const std::string& directory) {
  std::error_code ignored;
  const auto refuse = [](const fs::path& path) {
    refuse_folder(path.string(), "is a link, and a campaign follows none in its folder");
  };
  for (const char* const name : {"cases", "settings", "slurm", "inputs"}) {
    const fs::path folder = fs::path(directory) / name;
    if (fs::is_symlink(folder, ignored)) refuse(folder);
    for (const auto& entry : fs::directory_iterator(folder, ignored))
      if (entry.is_symlink(ignored)) refuse(entry.path());
  }
}

/// The `output.keep` of a done case, from the results in its manifest; nothing when it has none.
std::optional<std::string> kept_by(const fs::path& case_folder) {
  const std::string path = (case_folder / "manifest.json").string(), text = read_text(path);
  refuse_deep_json(text, path, "the manifest of a run");
  const auto manifest = nlohmann::json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!manifest.is_object() || !manifest.value("outputs", nlohmann::json()).is_array()) return {};
  std::string kept = "summary";
  for (const nlohmann::json& output : manifest["outputs"]) {
    const nlohmann::json name = output.is_object() ? output.value("path", nlohmann::json()) : nlohmann::json();
    if (name == "run.nc") return "run";
    if (name == "history.csv") kept = "history";
  }
  return kept;
}

bool holds_something(const fs::path& folder) {
  std::error_code is_not_there;
  return fs::is_directory(folder, is_not_there) && !fs::is_empty(folder, is_not_there);
}

}  // namespace

std::string Folder::id(const CaseKey& key) const {
  return fmt::format("{}-r{:04}", plan_.settings[key.setting].name, key.replicate);
}

CaseState Folder::state(const CaseKey& key) const {
  std::error_code ignored;
  if (fs::exists(case_folder(key) + "/summary.json", ignored)) return CaseState::kDone;
  return fs::exists(failure_record(key), ignored) ? CaseState::kFailed : CaseState::kMissing;
}

std::map<std::string, double> Folder::numbers(const CaseKey& key) const {
  const std::string path = case_folder(key) + "/summary.json";
  return columns_of(path, read_text(path));
}

/// The folder of a run, or of somebody else, has files of the same names, which would be lost.
void Folder::refuse_files_of_others() const {
  const std::optional<bool> manifest = has_campaign_manifest(directory_);
  if (manifest == false)
    refuse_folder(directory_, "holds results that are not a campaign's, as its manifest.json says");
  bool is_own = manifest.has_value();
  for (std::size_t i = 0; i < plan_.settings.size(); ++i) {
    const std::string path = setting_file(i);
    if (!fs::exists(path)) continue;
    if (read_text(path) != copies_->setting_text(plan_.settings[i])) {
      throw InputError(
          fmt::format("{}: is not what the plan makes of the setting {} now\n  allowed: the campaign that the "
                      "folder was begun with; settings and replicates may be added\n  remedy:  give another "
                      "folder; undo the change of the plan, its case or a file that the case names; or, after an "
                      "upgrade, take the version of the program that began it",
                      path, plan_.settings[i].name));
    }
    is_own = true;
  }
  if (is_own) return;
  for (const char* const name : {"campaign.csv", "campaign.nc", "summary.json", "report.html"})
    if (fs::exists(fs::symlink_status(fs::path(directory_) / name)))
      refuse_folder(directory_ + "/" + name, "is there, but no campaign left it, and this one would replace it");
  for (const char* const name : {"cases", "settings", "slurm", "inputs"})
    if (holds_something(fs::path(directory_) / name))
      refuse_folder(directory_ + "/" + name, "holds files, but none of this campaign");
}

/// A part of the cases would have no histories.
void Folder::refuse_other_keep() const {
  for (const auto& entry : fs::directory_iterator(fs::path(directory_) / "cases")) {
    if (entry.path().extension() == ".part" || !fs::exists(entry.path() / "summary.json")) continue;
    const std::optional<std::string> kept = kept_by(entry.path());
    if (kept && *kept != plan_.keep)
      throw InputError(
          Complaint{entry.path().string(),
                    fmt::format("was made with output.keep = \"{}\", and the plan says \"{}\" now", *kept, plan_.keep),
                    "one output.keep for the whole campaign", "put it back, or give another folder"});
  }
}

void Folder::prepare(bool resume) {
  refuse_links(directory_);
  copies_.emplace(plan_);
  refuse_files_of_others();
  std::error_code reason;
  const fs::path cases = fs::path(directory_) / "cases";
  fs::create_directories(cases, reason);
  if (reason)
    throw InputError(fmt::format("{}: cannot be made: {}\n  remedy:  check the path and its permissions",
                                 cases.string(), reason.message()));
  if (!resume && !fs::is_empty(cases))
    throw InputError(fmt::format(
        "{}: holds the cases of a campaign already\n  remedy:  `--resume`, in Python resume=True, continues "
        "with them; or "
        "give another folder",
        directory_));
  refuse_other_keep();
  const fs::path inputs = fs::path(directory_) / "inputs";
  for (const fs::path& written_to : {fs::path(directory_), cases, fs::path(directory_) / "settings", inputs})
    remove_parts(written_to);
  for (const auto& entry : fs::directory_iterator(inputs, reason))
    if (entry.is_directory(reason)) remove_parts(entry.path());
  // A worker that was killed just after it gave the folder of a case its name left the lock there.
  for (const auto& entry : fs::directory_iterator(cases))
    if (entry.path().extension() != ".part") FolderLock::remove_stale((entry.path() / "lock").string());
  // The settings first: they say whose folder it is, should the copies find no space.
  for (std::size_t i = 0; i < plan_.settings.size(); ++i)
    if (const std::string path = setting_file(i); !fs::exists(path))
      write_file(path, copies_->setting_text(plan_.settings[i]));
  copies_->write(directory_);
}

void Folder::remove_unfit(const std::function<void(const std::string& what)>& unfit) const {
  const int most = plan_.stop ? plan_.stop->most_replicates : plan_.replicates;
  for (std::size_t setting = 0; setting < plan_.settings.size(); ++setting) {
    std::optional<model::Case> expected;
    for (int replicate = 0; replicate < most; ++replicate) {
      const CaseKey key{setting, replicate};
      if (state(key) != CaseState::kDone) continue;
      if (!expected) expected = recording::read_inputs(setting_file(setting), {}, io::ModelFile::kAnywhere).recorded();
      expected->random.replicate = replicate;
      const std::string why = why_unfit(case_folder(key), *expected);
      if (why.empty()) continue;
      unfit(case_folder(key) + ": " + why);
      fs::remove_all(case_folder(key));
    }
  }
}

Job Folder::job_of(const CaseKey& key, const std::string& program) const {
  return {
      .command = {program, "campaign-case", setting_file(key.setting), case_folder(key), "--replicate",
                  std::to_string(key.replicate), "--keep", plan_.keep},
      // Not in the folder of the case, which gets another name when the case is done, by an earlier process perhaps.
      .messages = part_of(case_folder(key) + ".messages"),
      .folder = case_folder(key) + ".part",
      .result = case_folder(key) + "/summary.json",
      .record = failure_record(key)};
}

}  // namespace brash::campaign
