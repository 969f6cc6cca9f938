// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "brash/core/error.hpp"
#include "brash/training/database.hpp"
#include "chunked_build.hpp"

namespace brash::training {
namespace {

namespace fs = std::filesystem;

bool has_digits(const std::string& name, std::size_t from, std::size_t to) {
  return from < to &&
         std::all_of(name.begin() + static_cast<std::ptrdiff_t>(from), name.begin() + static_cast<std::ptrdiff_t>(to),
                     [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// Whether a build, and nobody else, gives this name to the files that it puts beside its chunks.
bool is_name_of_a_build(const std::string& name) {
  const bool is_chunk = name.size() == 9 && name.ends_with(".nc") && has_digits(name, 0, 6);
  const bool is_part =
      name.size() > 9 && name.substr(6).starts_with(".nc.") && has_digits(name, 0, 6) && name.ends_with(".part");
  return is_chunk || is_part || name == "lock" || name == "slurm";
}

/// Whether Slurm's rounds leave a file of this name: the script, the lists of jobs, the output of the jobs.
bool is_name_of_a_round(const std::string& name) {
  return name == "exec.sh" || name == "submitted.json" || name.ends_with(".txt") || name.ends_with(".part") ||
         (name.starts_with("round-") && name.ends_with(".json"));
}

template <typename IsOwn>
void remove_files(const fs::path& folder, IsOwn is_own) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (!entry.is_symlink(ignored) && entry.is_regular_file(ignored) && is_own(entry.path().filename().string()))
      fs::remove(entry.path(), ignored);
}

}  // namespace

void remove_chunks(const std::string& path) {
  const fs::path folder = path + ".chunks", rounds = folder / "slurm";
  std::error_code is_not_empty;
  if (!fs::is_symlink(rounds, is_not_empty)) remove_files(rounds, is_name_of_a_round);
  fs::remove(rounds, is_not_empty);
  remove_files(folder, [](const std::string& name) { return name != "lock" && is_name_of_a_build(name); });
  fs::remove(folder, is_not_empty);
}

void refuse_files_of_others(const std::string& path) {
  const fs::path folder = path + ".chunks";
  std::error_code ignored;
  const auto refuse = [](const fs::path& found) {
    throw InputError(Complaint{found.string(), "is there, but no build of a database left it",
                               "no folder of this name, or one with the chunks of this database",
                               "move it away, or give the database another name"});
  };
  if (fs::is_symlink(folder, ignored)) refuse(folder);
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.is_symlink(ignored) || !is_name_of_a_build(entry.path().filename().string())) refuse(entry.path());
}

std::string chunk_file(const std::string& path, int first) { return fmt::format("{}.chunks/{:06}.nc", path, first); }

}  // namespace brash::training
