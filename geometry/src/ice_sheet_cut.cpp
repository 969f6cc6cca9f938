// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <memory>

#include "brash/core/contract.hpp"
#include "ice_sheet_impl.hpp"

namespace brash::geometry {

void expect_region(std::span<const Point> ring) {
  constexpr auto kMost = static_cast<std::int64_t>(kMaxCoordinate / kGridUnit);
  BRASH_EXPECTS(ring.size() >= 3, ring.size());
  for (const Point p : ring) BRASH_EXPECTS(std::abs(p.x) <= kMost && std::abs(p.y) <= kMost, p.x, p.y);
  BRASH_EXPECTS(signed_area(ring) > ExactArea{}, signed_area(ring).square_metres());
}

PieceCycles trace_pieces(const Arrangement& arrangement) {
  const PlanarGraph& graph = arrangement.graph();
  std::vector<char> is_dropped(graph.size(), 0);
  const auto is_active = [&](int h) {
    if (!arrangement.is_piece_left(h)) return false;
    return !arrangement.is_piece_left(PlanarGraph::twin(h)) || !is_dropped[h];
  };
  PieceCycles pieces{graph.trace(is_active), {}, false};
  // A crack with the same face on both sides splits nothing.
  std::vector<int> cycle_of(graph.size(), -1);
  for (std::size_t k = 0; k < pieces.cycles.size(); ++k) {
    for (const int h : pieces.cycles[k]) cycle_of[h] = static_cast<int>(k);
  }
  std::vector<int> useless;
  bool is_any_in_ice = false;
  for (int h = 0; h < graph.size(); h += 2) {
    if (!graph[h].crack) continue;
    const bool in_ice = cycle_of[h] >= 0 && cycle_of[h + 1] >= 0;
    const bool in_water = cycle_of[h] < 0 && cycle_of[h + 1] < 0;
    if (in_ice && cycle_of[h] != cycle_of[h + 1]) {
      pieces.splitting.push_back({graph.from(h), graph.to(h)});
    } else if (in_ice || in_water) {
      useless.push_back(h);
      is_dropped[h] = is_dropped[h + 1] = 1;
      is_any_in_ice = is_any_in_ice || in_ice;
    }
  }
  if (useless.empty()) return pieces;
  std::vector<char> stays = arrangement.nodes_without_cracks();
  for (int h = 0; h < graph.size(); h += 2) {
    const bool splits = graph[h].crack && cycle_of[h] >= 0 && cycle_of[h + 1] >= 0 && cycle_of[h] != cycle_of[h + 1];
    if (splits) stays[graph[h].from] = stays[graph[h].to] = 1;
  }
  for (const int h : useless) pieces.has_traces = pieces.has_traces || !stays[graph[h].from] || !stays[graph[h].to];
  if (is_any_in_ice) pieces.cycles = graph.trace(is_active);
  return pieces;
}

SheetChange change_of(const Arrangement& arrangement, const FreeEdges& boundary) {
  const PlanarGraph& graph = arrangement.graph();
  SheetChange result;
  FreeEdges::Change& change = result.change;
  constexpr FreeEdges::Ref kNone = std::numeric_limits<int>::max();
  std::vector<FreeEdges::Ref> refs(graph.size(), kNone);
  change.removed.reserve(arrangement.active().size());
  change.added.reserve(graph.size() / 2);
  change.links.reserve(graph.size() / 2);
  std::vector<char> is_touched(graph.n_nodes(), 0);
  const auto touch = [&](int from, int to) { is_touched[from] = is_touched[to] = 1; };

  // Old edges that are still there stay; the others go.
  for (const Arrangement::ActiveEdge& e : arrangement.active()) {
    const int h = e.added < 0 ? -1 : graph.half_edge_of(e.added);
    if (h >= 0 && arrangement.is_new_sheet_edge(h)) {
      BRASH_EXPECTS(refs[h] == kNone, graph.from(h).x, graph.from(h).y);
      refs[h] = e.id;
      continue;
    }
    change.removed.push_back(e.id);
    result.twice_area -= exact::cross(boundary.edge(e.id).from, boundary.edge(e.id).to);
    touch(e.from, e.to);
  }
  const auto is_new = [&](int h) { return arrangement.is_new_sheet_edge(h); };
  for (int h = 0; h < graph.size(); ++h) {
    if (!is_new(h) || refs[h] != kNone) continue;
    refs[h] = ~static_cast<int>(change.added.size());
    change.added.push_back({graph.from(h), graph.to(h)});
    result.twice_area += exact::cross(graph.from(h), graph.to(h));
    touch(graph[h].from, graph[h].to);
  }
  for (int h = 0; h < graph.size(); ++h) {
    if (refs[h] != kNone && is_touched[graph[h].to])
      change.links.push_back({refs[h], refs[graph.next_in_face(h, is_new)]});
  }
  return result;
}

Cut IceSheet::cut(std::span<const Point> region, std::span<const Crack> cracks) {
  expect_region(region);
  FreeEdges& boundary = impl_->boundary;
  std::vector<Crack> inside = cracks_inside(region, cracks);
  auto arrangement = std::make_unique<Arrangement>(boundary, region, inside);
  PieceCycles pieces = trace_pieces(*arrangement);
  // Cracks that split nothing leave no trace, not even a vertex: where there is one, arrange again without them.
  while (pieces.has_traces) {
    inside = pieces.splitting;
    arrangement = std::make_unique<Arrangement>(boundary, region, inside);
    pieces = trace_pieces(*arrangement);
  }
  const PlanarGraph& graph = arrangement->graph();
  std::vector<Ring> rings;
  rings.reserve(pieces.cycles.size());
  Int128 twice_pieces = 0;
  for (const std::vector<int>& cycle : pieces.cycles) {
    rings.push_back(graph.ring_of(cycle));
    twice_pieces += graph.twice_area(cycle);
  }
  Cut cut;
  cut.pieces = polygons_of(std::move(rings));
  cut.snap = ExactArea(-arrangement->twice_moved());
  cut.n_rounded = arrangement->n_rounded();

  // What goes must be what comes, counted on both sides: the sheet from its edges, snap from the re-routed ones.
  const SheetChange sheet = change_of(*arrangement, boundary);
  BRASH_EXPECTS(sheet.twice_area + twice_pieces == arrangement->twice_moved(), ExactArea(sheet.twice_area).to_string(),
                ExactArea(twice_pieces).to_string(), cut.snap.to_string());
  const auto changes = [&](Point from, Point to) {
    cut.changed.add(metres(from));
    cut.changed.add(metres(to));
  };
  for (const int id : sheet.change.removed) changes(boundary.edge(id).from, boundary.edge(id).to);
  for (const FreeEdges::Directed& edge : sheet.change.added) changes(edge.from, edge.to);
  boundary.apply(sheet.change);
  return cut;
}

std::vector<Polygon> IceSheet::within(std::span<const Point> window) const {
  expect_region(window);
  const Arrangement arrangement(impl_->boundary, window, {});
  std::vector<Ring> rings;
  for (const std::vector<int>& cycle : trace_pieces(arrangement).cycles) {
    rings.push_back(arrangement.graph().ring_of(cycle));
  }
  return polygons_of(std::move(rings));
}

}  // namespace brash::geometry
