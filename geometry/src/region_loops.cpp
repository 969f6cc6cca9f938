// SPDX-License-Identifier: GPL-3.0-or-later
#include "region_loops.hpp"

#include <algorithm>

#include "brash/core/contract.hpp"

namespace brash::geometry {
namespace {

struct Edge {
  int from;
  int to;

  friend auto operator<=>(const Edge&, const Edge&) = default;
};

std::vector<Point> vertices_of(const Polygon& polygon) {
  std::vector<Point> points(polygon.outline);
  for (const Ring& hole : polygon.holes) points.insert(points.end(), hole.begin(), hole.end());
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

int index_of(const std::vector<Point>& points, Point p) {
  return static_cast<int>(std::lower_bound(points.begin(), points.end(), p) - points.begin());
}

/// Appends the edge, in pieces where vertices lie on it. Points between its ends in x are neighbours in the order.
void append_edge(const std::vector<Point>& points, int from, int to, std::vector<Edge>& edges) {
  const auto [low, high] = std::minmax(from, to);
  int last = from;
  const int step = from < to ? 1 : -1;
  for (int i = from + step; i > low && i < high; i += step) {
    if (!is_on_segment(points[i], points[low], points[high])) continue;
    edges.push_back({last, i});
    last = i;
  }
  edges.push_back({last, to});
}

void append_ring(const std::vector<Point>& points, const Ring& ring, std::vector<Edge>& edges) {
  if (ring.empty()) return;
  const int first = index_of(points, ring[0]);
  int from = first;
  for (std::size_t i = 1; i <= ring.size(); ++i) {
    const int to = i == ring.size() ? first : index_of(points, ring[i]);
    if (from != to) append_edge(points, from, to, edges);
    from = to;
  }
}

/// Leaves out the pairs of edges that run along each other in opposite directions. `edges` is sorted.
std::vector<Edge> without_opposite_pairs(const std::vector<Edge>& edges) {
  std::vector<Edge> kept;
  kept.reserve(edges.size());
  for (const Edge& e : edges) {
    if (!std::binary_search(edges.begin(), edges.end(), Edge{e.to, e.from})) kept.push_back(e);
  }
  return kept;
}

/// The first edge out of `in.to` met when turning clockwise from the way back: nothing lies between on the inside.
std::size_t next_edge(const std::vector<Point>& points, const std::vector<Edge>& edges, const Edge& in) {
  const auto begin = std::lower_bound(edges.begin(), edges.end(), Edge{in.to, -1});
  BRASH_EXPECTS(begin != edges.end() && begin->from == in.to, points[in.to].x, points[in.to].y);
  auto best = begin;
  for (auto it = begin + 1; it != edges.end() && it->from == in.to; ++it) {
    if (is_in_sector(points[in.from], points[in.to], points[best->to], points[it->to])) best = it;
  }
  return static_cast<std::size_t>(best - edges.begin());
}

}  // namespace

RegionLoops region_loops(const Polygon& polygon) {
  RegionLoops region{.points = vertices_of(polygon), .loops = {}};
  std::vector<Edge> edges;
  append_ring(region.points, polygon.outline, edges);
  for (const Ring& hole : polygon.holes) append_ring(region.points, hole, edges);
  std::sort(edges.begin(), edges.end());
  const auto twice = std::adjacent_find(edges.begin(), edges.end());
  BRASH_EXPECTS(twice == edges.end(), "the boundary runs twice along an edge", region.points[twice->from].x,
                region.points[twice->from].y);
  edges = without_opposite_pairs(edges);

  std::vector<bool> is_done(edges.size(), false);
  for (std::size_t start = 0; start < edges.size(); ++start) {
    if (is_done[start]) continue;
    Loop loop;
    for (std::size_t e = start; !is_done[e]; e = next_edge(region.points, edges, edges[e])) {
      is_done[e] = true;
      loop.push_back(edges[e].from);
    }
    region.loops.push_back(std::move(loop));
  }
  return region;
}

}  // namespace brash::geometry
