// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "brash/core/error.hpp"
#include "brash/core/sha256.hpp"
#include "brash/database/database.hpp"
#include "store.hpp"

namespace brash::database {
namespace {

namespace fs = std::filesystem;

/// Geometries in a chunk: the most that a killed build may lose.
constexpr int kChunk = 16;

Record solve(int geometry, const DesignPoint& point, const Plan& plan) {
  Record record{.geometry = geometry, .plate = point.plate};
  auto profiles = plate::solve(point.plate, plan.mesh);
  if (!profiles) {
    record.error = profiles.error().what;
    return record;
  }
  record.solved = true;
  record.profiles = std::move(*profiles);
  for (const LoadPoint& load : point.loads) {
    record.rows.push_back({load, plate::respond(record.profiles, point.plate.thickness, load.mu1, load.mu2)});
  }
  return record;
}

/// The database at `path` if it is there.
/// @throws InputError when it was made for another plan.
bool read_if_there(const std::string& path, const std::string& plan_sha256, Database& database) {
  if (!fs::exists(path)) return false;
  database = read_database(path);
  if (database.plan_sha256 == plan_sha256) return true;
  throw InputError(Complaint{path, "was computed for another plan", "a database of this plan, or no file",
                             "remove it, or give another output name"});
}

void count(const std::vector<Record>& records, Progress& progress) {
  for (const Record& r : records) {
    ++progress.done;
    if (!r.solved) ++progress.failed;
  }
}

/// A part of the database of `plan`, without records yet.
Database empty_part(const Plan& plan) { return {.plan = to_text(plan), .plan_sha256 = sha256(to_text(plan))}; }

std::vector<Record> solve_geometries(const Plan& plan, const std::vector<DesignPoint>& points, int first) {
  std::vector<Record> records;
  for (int g = first; g < std::min(first + kChunk, plan.geometries); ++g)
    records.push_back(solve(g, points[static_cast<std::size_t>(g)], plan));
  return records;
}

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

/// Removes the chunks, and their folder once it is empty: the holder of the lock in it removes it otherwise.
void remove_chunks(const std::string& path) {
  const fs::path folder = path + ".chunks", rounds = folder / "slurm";
  std::error_code is_not_empty;
  if (!fs::is_symlink(rounds, is_not_empty)) remove_files(rounds, is_name_of_a_round);
  fs::remove(rounds, is_not_empty);
  remove_files(folder, [](const std::string& name) { return name != "lock" && is_name_of_a_build(name); });
  fs::remove(folder, is_not_empty);
}

/// @throws InputError when the folder of the chunks holds a file that no build left, or is a link.
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

}  // namespace

std::string chunk_file(const std::string& path, int first) { return fmt::format("{}.chunks/{:06}.nc", path, first); }

std::vector<int> missing_chunks(const Plan& plan, const std::string& path) {
  std::vector<int> missing;
  const std::string plan_sha256 = empty_part(plan).plan_sha256;
  Database there;
  if (read_if_there(path, plan_sha256, there)) return missing;
  refuse_files_of_others(path);
  for (int first = 0; first < plan.geometries; first += kChunk)
    if (!read_if_there(chunk_file(path, first), plan_sha256, there)) missing.push_back(first);
  return missing;
}

void solve_chunk(const Plan& plan, const std::string& path, int first) {
  Database chunk = empty_part(plan);
  const std::string file = chunk_file(path, first);
  fs::create_directories(fs::path(file).parent_path());
  chunk.records = solve_geometries(plan, design(plan), first);
  write_database(file, chunk);
}

Progress build(const Plan& plan, const std::string& path, const std::function<bool(const Progress&)>& go_on) {
  const std::vector<DesignPoint> points = design(plan);
  Database whole = empty_part(plan);
  Progress progress{.total = plan.geometries};
  if (Database there; read_if_there(path, whole.plan_sha256, there)) {
    count(there.records, progress);
    return progress;
  }

  refuse_files_of_others(path);
  fs::create_directories(path + ".chunks");
  for (int first = 0; first < plan.geometries; first += kChunk) {
    Database chunk = empty_part(plan);
    if (!read_if_there(chunk_file(path, first), whole.plan_sha256, chunk)) {
      chunk.records = solve_geometries(plan, points, first);
      write_database(chunk_file(path, first), chunk);
    }
    count(chunk.records, progress);
    std::move(chunk.records.begin(), chunk.records.end(), std::back_inserter(whole.records));
    if (go_on && !go_on(progress)) return progress;
  }

  write_database(path, whole);
  remove_chunks(path);
  return progress;
}

}  // namespace brash::database
