// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "brash/core/error.hpp"
#include "brash/core/sha256.hpp"
#include "brash/training/database.hpp"
#include "brash/training/edge_database.hpp"

namespace brash::training {

/// Writes `database` as netCDF-4 to `path` by rename when whole.
/// @throws RunError when it cannot be written.
void write_database(const std::string& path, const Database& database);

/// Writes `database` as netCDF-4 to `path` by rename when whole.
/// @throws RunError when it cannot be written.
void write_edge_database(const std::string& path, const EdgeDatabase& database);

/// Removes the chunks of `path`, and their folder once it is empty: the holder of the lock in it removes it otherwise.
void remove_chunks(const std::string& path);

/// @throws InputError when the folder of the chunks holds a file that no build left, or is a link.
void refuse_files_of_others(const std::string& path);

/// How the databases of a kind of plan are computed, piece by piece.
template <typename PlanOf, typename DatabaseOf>
struct Pieces {
  int total = 0;  ///< records of the whole
  int chunk = 0;  ///< the most that a killed build may lose
  std::function<DatabaseOf(const std::string& path)> read;
  std::function<void(const std::string& path, const DatabaseOf& database)> write;
  /// Records from `first` to `last`, exclusive.
  std::function<decltype(DatabaseOf::records)(int first, int last)> solve;
};

/// A part of the database of `plan`, without records yet.
template <typename DatabaseOf, typename PlanOf>
DatabaseOf empty_part(const PlanOf& plan) {
  DatabaseOf part;
  part.plan = to_text(plan);
  part.plan_sha256 = sha256(part.plan);
  return part;
}

/// The database at `path` if it is there.
/// @throws InputError when it was made for another plan.
template <typename PlanOf, typename DatabaseOf>
bool read_if_there(const Pieces<PlanOf, DatabaseOf>& pieces, const std::string& path, const std::string& plan_sha256,
                   DatabaseOf& database) {
  if (!std::filesystem::exists(path)) return false;
  database = pieces.read(path);
  if (database.plan_sha256 == plan_sha256) return true;
  throw InputError(Complaint{path, "was computed for another plan", "a database of this plan, or no file",
                             "remove it, or give another output name"});
}

template <typename PlanOf, typename DatabaseOf>
std::vector<int> missing_in(const Pieces<PlanOf, DatabaseOf>& pieces, const PlanOf& plan, const std::string& path) {
  std::vector<int> missing;
  const std::string plan_sha256 = empty_part<DatabaseOf>(plan).plan_sha256;
  DatabaseOf there;
  if (read_if_there(pieces, path, plan_sha256, there)) return missing;
  refuse_files_of_others(path);
  for (int first = 0; first < pieces.total; first += pieces.chunk)
    if (!read_if_there(pieces, chunk_file(path, first), plan_sha256, there)) missing.push_back(first);
  return missing;
}

template <typename PlanOf, typename DatabaseOf>
void write_chunk(const Pieces<PlanOf, DatabaseOf>& pieces, const PlanOf& plan, const std::string& path, int first) {
  DatabaseOf chunk = empty_part<DatabaseOf>(plan);
  const std::string file = chunk_file(path, first);
  std::filesystem::create_directories(std::filesystem::path(file).parent_path());
  chunk.records = pieces.solve(first, std::min(first + pieces.chunk, pieces.total));
  pieces.write(file, chunk);
}

template <typename Records>
void count_records(const Records& records, Progress& progress) {
  for (const auto& r : records) {
    ++progress.done;
    if (!r.solved) ++progress.failed;
  }
}

template <typename PlanOf, typename DatabaseOf>
Progress build_from(const Pieces<PlanOf, DatabaseOf>& pieces, const PlanOf& plan, const std::string& path,
                    const std::function<bool(const Progress&)>& go_on) {
  DatabaseOf whole = empty_part<DatabaseOf>(plan);
  Progress progress{.total = pieces.total};
  if (DatabaseOf there; read_if_there(pieces, path, whole.plan_sha256, there)) {
    count_records(there.records, progress);
    return progress;
  }

  refuse_files_of_others(path);
  std::filesystem::create_directories(path + ".chunks");
  for (int first = 0; first < pieces.total; first += pieces.chunk) {
    DatabaseOf chunk;
    if (!read_if_there(pieces, chunk_file(path, first), whole.plan_sha256, chunk)) {
      chunk = empty_part<DatabaseOf>(plan);
      chunk.records = pieces.solve(first, std::min(first + pieces.chunk, pieces.total));
      pieces.write(chunk_file(path, first), chunk);
    }
    count_records(chunk.records, progress);
    std::move(chunk.records.begin(), chunk.records.end(), std::back_inserter(whole.records));
    if (go_on && !go_on(progress)) return progress;
  }

  pieces.write(path, whole);
  remove_chunks(path);
  return progress;
}

}  // namespace brash::training
