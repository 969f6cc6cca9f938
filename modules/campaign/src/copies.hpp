// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brash/io/campaign_plan.hpp"

namespace brash::campaign {

/// A file that a campaign was made from, and its copy in the folder of the campaign.
struct CopiedFile {
  std::string path;  ///< as given
  std::string sha256;
  std::string copy;  ///< relative to the folder of the campaign
};

/// The copies of a plan's files: plan, base case, models, meshes, files of the ice. Cases run from the copies. The name
/// of a copy holds a part of its hash, so a file that has changed makes another setting.
class Copies {
 public:
  /// Hashes the files. @throws InputError naming a file that cannot be read.
  explicit Copies(const io::CampaignPlan& plan);

  const std::vector<CopiedFile>& files() const { return files_; }
  /// The text of a setting's file: the resolved case, which names the copies relative to the folder of the settings.
  std::string setting_text(const io::Setting& setting) const;
  /// Writes the copies that are not there yet into `directory`.
  /// @throws InputError naming a file that has changed since it was hashed.
  void write(const std::string& directory) const;

 private:
  void add(const std::string& folder, const std::string& path);

  const io::CampaignPlan& plan_;
  std::vector<CopiedFile> files_;  ///< the sources of the plan first
};

}  // namespace brash::campaign
