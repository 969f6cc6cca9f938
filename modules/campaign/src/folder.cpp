// SPDX-License-Identifier: GPL-3.0-or-later
#include "folder.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "brash/core/error.hpp"
#include "brash/core/write_file.hpp"
#include "brash/io/case.hpp"
#include "brash/io/results.hpp"
#include "columns.hpp"

namespace brash::campaign {

namespace fs = std::filesystem;

std::string read_text(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

namespace {

/// The folder of a run has files of the same names, which would be lost.
void refuse_other_results(const std::string& directory) {
  const std::string path = directory + "/manifest.json";
  if (!fs::exists(path)) return;
  const auto manifest = nlohmann::json::parse(read_text(path), nullptr, /*allow_exceptions=*/false);
  if (manifest.is_object() && manifest.contains("format") && manifest["format"] == kManifestFormat) return;
  throw InputError(Complaint{directory, "holds results that are not a campaign's, as its manifest.json says",
                             "a folder that is new, empty or of this campaign", "give another folder"});
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

std::optional<double> Folder::value(const CaseKey& key, const std::string& column) const {
  const std::string path = case_folder(key) + "/summary.json";
  const auto columns = columns_of(path, read_text(path));
  const auto found = columns.find(column);
  return found == columns.end() ? std::nullopt : std::optional(found->second);
}

void Folder::prepare(bool resume) const {
  refuse_other_results(directory_);
  std::error_code reason;
  const fs::path cases = fs::path(directory_) / "cases";
  fs::create_directories(cases, reason);
  if (reason)
    throw InputError(fmt::format("{}: cannot be made: {}\n  remedy:  check the path and its permissions",
                                 cases.string(), reason.message()));
  if (!resume && !fs::is_empty(cases))
    throw InputError(
        fmt::format("{}: holds the cases of a campaign already\n  remedy:  `--resume` goes on with them; or "
                    "give another folder",
                    directory_));
  for (const fs::path& written_to : {fs::path(directory_), cases, fs::path(directory_) / "settings"})
    remove_parts(written_to);
  // A worker that was killed just after it gave the folder of a case its name left the lock there.
  for (const auto& entry : fs::directory_iterator(cases))
    if (entry.path().extension() != ".part") fs::remove(entry.path() / "lock", reason);
  for (std::size_t i = 0; i < plan_.settings.size(); ++i) {
    const std::string text = io::to_toml(plan_.settings[i].resolved);
    const std::string path = setting_file(i);
    if (!fs::exists(path)) {
      write_file(path, text);
    } else if (read_text(path) != text) {
      throw InputError(
          fmt::format("{}: is not what the plan makes of the setting {} now\n  allowed: the campaign that the "
                      "folder was begun with; settings and replicates may be added\n  remedy:  give another "
                      "folder, or undo the change of the plan or its case",
                      path, plan_.settings[i].name));
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
