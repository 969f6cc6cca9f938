// SPDX-License-Identifier: GPL-3.0-or-later
#include "copies.hpp"

#include <algorithm>
#include <filesystem>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/sha256.hpp"
#include "brash/core/write_file.hpp"
#include "brash/io/case.hpp"
#include "brash/recording/inputs.hpp"

namespace brash::campaign {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostMebibytes = 512;  // of the largest, a mesh

/// "hull-1a2b3c4d.obj"
std::string hashed_name(const fs::path& path, const std::string& sha256) {
  constexpr std::size_t kDigits = 8;
  return path.stem().string() + "-" + sha256.substr(0, kDigits) + path.extension().string();
}

bool has_hash(const fs::path& file, const std::string& sha256) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored) && sha256_of_file(file.string()) == sha256;
}

}  // namespace

Copies::Copies(const io::CampaignPlan& plan) : plan_(plan) {
  for (const io::SourceText& source : plan.sources) {
    const std::string digest = sha256(source.text);
    const std::string plain = "inputs/" + fs::path(source.path).filename().string();
    // The base case may have the name of the plan.
    const bool is_taken = std::ranges::find(files_, plain, &CopiedFile::copy) != files_.end();
    files_.push_back({source.path, digest, is_taken ? "inputs/" + hashed_name(source.path, digest) : plain});
  }
  for (const io::Setting& setting : plan.settings) {
    model::Case resolved = setting.resolved;
    recording::visit_own_files(resolved, [&](const std::string& folder, std::string& file) { add(folder, file); });
  }
}

void Copies::add(const std::string& folder, const std::string& path) {
  const auto is_known = [&](const CopiedFile& known) { return known.path == path && known.copy.starts_with(folder); };
  if (std::ranges::any_of(files_, is_known)) return;
  const std::string digest = sha256(read_text_file(path, "an input of a campaign", kMostMebibytes));
  files_.push_back({path, digest, folder + hashed_name(path, digest)});
}

std::string Copies::setting_text(const io::Setting& setting) const {
  model::Case named = setting.resolved;
  recording::visit_own_files(named, [&](const std::string& folder, std::string& file) {
    const auto copied = std::ranges::find_if(
        files_, [&](const CopiedFile& known) { return known.path == file && known.copy.starts_with(folder); });
    file = "../" + copied->copy;
  });
  return io::to_toml(named);
}

void Copies::write(const std::string& directory) const {
  for (std::size_t i = 0; i < files_.size(); ++i) {
    const CopiedFile& file = files_[i];
    const std::string copy = directory + "/" + file.copy;
    if (has_hash(copy, file.sha256)) continue;
    const std::string bytes = i < plan_.sources.size()
                                  ? plan_.sources[i].text
                                  : read_text_file(file.path, "an input of a campaign", kMostMebibytes);
    if (sha256(bytes) != file.sha256)
      throw InputError(Complaint{file.path, "has changed while the campaign was reading it",
                                 "one file for the whole campaign", "start again when nobody writes it"});
    write_file(copy, bytes);
  }
}

}  // namespace brash::campaign
