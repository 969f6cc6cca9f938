// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/training/database.hpp"
#include "chunked_build.hpp"

namespace brash::training {
namespace {

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

Pieces<Plan, Database> pieces_of(const Plan& plan) {
  return {.total = plan.geometries,
          .chunk = kChunk,
          .read = read_database,
          .write = write_database,
          .solve = [&plan, points = design(plan)](int first, int last) {
            std::vector<Record> records;
            for (int g = first; g < last; ++g) records.push_back(solve(g, points[static_cast<std::size_t>(g)], plan));
            return records;
          }};
}

}  // namespace

std::vector<int> missing_chunks(const Plan& plan, const std::string& path) {
  return missing_in(pieces_of(plan), plan, path);
}

void solve_chunk(const Plan& plan, const std::string& path, int first) {
  write_chunk(pieces_of(plan), plan, path, first);
}

Progress build(const Plan& plan, const std::string& path, const std::function<bool(const Progress&)>& go_on) {
  return build_from(pieces_of(plan), plan, path, go_on);
}

}  // namespace brash::training
