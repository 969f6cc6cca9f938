// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "brash/campaign/pool.hpp"
#include "brash/io/campaign_plan.hpp"
#include "copies.hpp"

namespace brash::campaign {

/// Which case of its campaign a case is.
struct CaseKey {
  std::size_t setting = 0;
  int replicate = 0;
};

enum class CaseState { kMissing, kDone, kFailed };

/// The folder of a campaign: where everything of it lies.
class Folder {
 public:
  Folder(const io::CampaignPlan& plan, std::string directory) : plan_(plan), directory_(std::move(directory)) {}

  const std::string& directory() const { return directory_; }
  /// "angle-50deg-r0003"
  std::string id(const CaseKey& key) const;
  std::string case_folder(const CaseKey& key) const { return directory_ + "/cases/" + id(key); }
  std::string failure_record(const CaseKey& key) const { return case_folder(key) + ".failed"; }
  std::string setting_file(std::size_t setting) const {
    return directory_ + "/settings/" + plan_.settings[setting].resolved.name + ".toml";
  }
  CaseState state(const CaseKey& key) const;
  /// The numbers of a done case by their columns.
  std::map<std::string, double> numbers(const CaseKey& key) const;

  /// Makes the folder with its settings and the copies of their files.
  /// @throws InputError when a setting of that name is there already and differs, when cases are there and `resume`
  ///         is false, or when there are files of something else, or links.
  void prepare(bool resume);
  /// Removes the done cases of the plan that are not as this campaign made them, so that they are run again.
  /// @param unfit  is called with a message for each of these cases before it is removed.
  void remove_unfit(const std::function<void(const std::string& what)>& unfit) const;
  /// The plan's files, as prepare() hashed them.
  const std::vector<CopiedFile>& copied_files() const { return copies_.value().files(); }
  /// The process that runs a case.
  Job job_of(const CaseKey& key, const std::string& program) const;

 private:
  void refuse_files_of_others() const;
  void refuse_other_keep() const;

  const io::CampaignPlan& plan_;
  std::string directory_;
  std::optional<Copies> copies_;
};

/// The bytes of a file; "" when the path is not a file, or cannot be read.
std::string read_text(const std::filesystem::path& path);

}  // namespace brash::campaign
