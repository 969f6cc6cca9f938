// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "brash/training/edge_database.hpp"
#include "chunked_build.hpp"

namespace brash::training {
namespace {

/// Outlines in a chunk: the most that a killed build may lose.
constexpr int kOutlines = 4;

bool same_outline(const plate::EdgeGeometry& a, const plate::EdgeGeometry& b) {
  return a.depth == b.depth && a.contact_length == b.contact_length && a.angle == b.angle;
}

std::vector<EdgeRecord> solve(const std::vector<plate::EdgeGeometry>& geometries, const EdgePlan& plan, int first,
                              int last) {
  std::vector<EdgeRecord> records;
  std::optional<tl::expected<plate::MovingEdge, plate::PlateError>> edge;
  for (int i = first; i < last; ++i) {
    const plate::EdgeGeometry& geometry = geometries[static_cast<std::size_t>(i)];
    if (!edge || !same_outline(geometry, records.back().geometry))
      edge = plate::MovingEdge::prepare(geometry, plan.options);
    EdgeRecord record{.index = i, .geometry = geometry};
    if (!*edge) {
      record.error = edge->error().what;
    } else if (auto responses = (*edge)->respond(geometry)) {
      record.solved = true;
      record.responses = std::move(*responses);
    } else {
      record.error = responses.error().what;
    }
    records.push_back(std::move(record));
  }
  return records;
}

Pieces<EdgePlan, EdgeDatabase> pieces_of(const EdgePlan& plan) {
  std::vector<plate::EdgeGeometry> geometries = design(plan);
  return {.total = static_cast<int>(geometries.size()),
          .chunk = kOutlines * static_cast<int>(plan.thickness_over_lc.size()),
          .read = read_edge_database,
          .write = write_edge_database,
          .solve = [&plan, geometries](int first, int last) { return solve(geometries, plan, first, last); }};
}

}  // namespace

std::vector<int> missing_chunks(const EdgePlan& plan, const std::string& path) {
  return missing_in(pieces_of(plan), plan, path);
}

void solve_chunk(const EdgePlan& plan, const std::string& path, int first) {
  write_chunk(pieces_of(plan), plan, path, first);
}

Progress build(const EdgePlan& plan, const std::string& path, const std::function<bool(const Progress&)>& go_on) {
  return build_from(pieces_of(plan), plan, path, go_on);
}

}  // namespace brash::training
