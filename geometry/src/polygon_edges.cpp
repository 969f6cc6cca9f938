// SPDX-License-Identifier: GPL-3.0-or-later
#include "polygon_edges.hpp"

#include <algorithm>
#include <sstream>

#include "brash/core/interruption.hpp"
#include "exact.hpp"

namespace brash::geometry {
namespace {

using exact::Box;

int node_at(const std::vector<Point>& nodes, Point p) {
  return static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), p) - nodes.begin());
}

}  // namespace

std::string place(Point p) {
  std::ostringstream text;
  text.precision(17);
  text << '(' << metres(p).x << ", " << metres(p).y << ')';
  return text.str();
}

std::string polygon_name(std::size_t i) { return "polygon " + std::to_string(i); }

void PolygonEdges::insert(const Edge& edge) {
  index_.insert(static_cast<int>(edges_.size()), edge.from, edge.to);
  edges_.push_back(edge);
}

std::string PolygonEdges::add_ring(Ring ring, bool is_hole, std::size_t polygon) {
  constexpr auto kMost = static_cast<std::int64_t>(kMaxCoordinate / kGridUnit);
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  const std::string name = polygon_name(polygon) + (is_hole ? ", a hole" : ", the outline");
  if (ring.size() < 3) return name + ": has fewer than 3 different vertices";
  for (const Point p : ring) {
    if (std::abs(p.x) > kMost || std::abs(p.y) > kMost) return name + ": beyond the grid at " + place(p);
  }
  const ExactArea enclosed = signed_area(ring);
  if (enclosed == ExactArea{} && flat_ring_.empty()) flat_ring_ = name + ": has no area, at " + place(ring.front());
  if ((enclosed < ExactArea{}) != is_hole) std::reverse(ring.begin(), ring.end());
  for (std::size_t i = 0; i < ring.size(); ++i) insert({ring[i], ring[i + 1 == ring.size() ? 0 : i + 1], polygon});
  return {};
}

std::string PolygonEdges::add(const Polygon& polygon, std::size_t number) {
  std::string fault = add_ring(polygon.outline, false, number);
  for (const Ring& hole : polygon.holes)
    if (fault.empty()) fault = add_ring(hole, true, number);
  return fault;
}

std::vector<PolygonEdges::Crossing> PolygonEdges::crossings() const {
  std::vector<Crossing> found;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    look_for_interruption();
    const Edge& a = edges_[i];
    index_.query(Box::of(a.from, a.to), [&](int j) {
      const Edge& b = edges_[static_cast<std::size_t>(j)];
      if (static_cast<std::size_t>(j) >= i || !exact::cross_properly(a.from, a.to, b.from, b.to)) return;
      const auto [first, second] = std::minmax(a.polygon, b.polygon);
      found.push_back({first, second, exact::rounded_crossing(a.from, a.to, b.from, b.to)});
    });
  }
  return found;
}

/// Leads an edge through the vertices in whose pixels it comes.
void PolygonEdges::route(int from, int to, Noded& noded) const {
  look_for_interruption();
  const Point a = noded.nodes[static_cast<std::size_t>(from)];
  const Point b = noded.nodes[static_cast<std::size_t>(to)];
  Ring met;
  index_.query(Box::of(a, b), [&](int id) {
    const Point p = edges_[static_cast<std::size_t>(id)].from;
    if (p != a && p != b && exact::meets_pixel(a, b, p)) met.push_back(p);
  });
  std::sort(met.begin(), met.end(), [&](Point p, Point q) {
    const Int128 dp = exact::dot(a, b, p);
    const Int128 dq = exact::dot(a, b, q);
    return dp != dq ? dp < dq : p < q;
  });
  met.erase(std::unique(met.begin(), met.end()), met.end());
  int last = from;
  for (const Point p : met) {
    route(last, node_at(noded.nodes, p), noded);
    last = node_at(noded.nodes, p);
  }
  if (met.empty()) {
    noded.edges.push_back({from, to, Source::kSheet});
    noded.twice_moved += exact::cross(a, b);
  } else {
    route(last, to, noded);
  }
}

PolygonEdges::Noded PolygonEdges::noded(const std::vector<Crossing>& crossings) {
  const std::size_t n = edges_.size();
  for (const Crossing& crossing : crossings) insert({crossing.at, crossing.at, crossing.first});
  Noded result;
  for (const Edge& edge : edges_) result.nodes.push_back(edge.from);
  std::sort(result.nodes.begin(), result.nodes.end());
  result.nodes.erase(std::unique(result.nodes.begin(), result.nodes.end()), result.nodes.end());
  for (std::size_t i = 0; i < n; ++i) {
    result.twice_moved -= exact::cross(edges_[i].from, edges_[i].to);
    route(node_at(result.nodes, edges_[i].from), node_at(result.nodes, edges_[i].to), result);
  }
  return result;
}

}  // namespace brash::geometry
