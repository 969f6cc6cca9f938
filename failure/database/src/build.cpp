// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>

#include "brash/core/error.hpp"
#include "brash/core/sha256.hpp"
#include "brash/database/database.hpp"
#include "store.hpp"

namespace brash::database {
namespace {

namespace fs = std::filesystem;

/// Geometries in a chunk: what a killed build may lose.
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

}  // namespace

std::string chunk_file(const std::string& path, int first) { return fmt::format("{}.chunks/{:06}.nc", path, first); }

std::vector<int> missing_chunks(const Plan& plan, const std::string& path) {
  std::vector<int> missing;
  const std::string plan_sha256 = empty_part(plan).plan_sha256;
  Database there;
  if (read_if_there(path, plan_sha256, there)) return missing;
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
  fs::remove_all(path + ".chunks");
  return progress;
}

}  // namespace brash::database
