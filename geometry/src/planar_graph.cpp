// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar_graph.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "brash/core/contract.hpp"

namespace brash::geometry {

void PlanarGraph::join_coincident() {
  // For each node a list, by `clockwise`, of the edges to larger nodes.
  std::vector<int> newest(nodes_->size(), -1);
  half_.resize(2 * raw_.size());
  int n = 0;
  for (Raw& e : raw_) {
    const auto [low, high] = std::minmax(e.from, e.to);
    int along = newest[low];
    while (along >= 0 && half_[along].to != high) along = half_[along].clockwise;
    if (along < 0) {
      along = n;
      half_[n++] = {.from = low, .to = high, .clockwise = newest[low]};
      half_[n++] = {.from = high, .to = low};
      newest[low] = along;
    }
    e.half_edge = e.from == low ? along : twin(along);
    HalfEdge& with = half_[e.half_edge];
    HalfEdge& against = half_[twin(e.half_edge)];
    if (e.source == Source::kSheet) ++with.sheet, --against.sheet;
    if (e.source == Source::kRegion) ++with.region, --against.region;
    if (e.source == Source::kCrack) with.crack = against.crack = true;
  }
  half_.resize(n);
}

void PlanarGraph::drop_cancelled() {
  const auto is_cancelled = [](const HalfEdge& h) { return h.sheet == 0 && h.region == 0 && !h.crack; };
  if (std::none_of(half_.begin(), half_.end(), is_cancelled)) return;
  std::vector<int> moved_to(half_.size(), -1);
  int kept = 0;
  for (int h = 0; h < size(); ++h) {
    if (is_cancelled(half_[h])) continue;
    half_[kept] = half_[h];
    moved_to[h] = kept++;
  }
  half_.resize(kept);
  for (Raw& e : raw_) e.half_edge = moved_to[e.half_edge];
}

void PlanarGraph::order_around_nodes() {
  const std::vector<Point>& nodes = *nodes_;
  // Rings in any order first: that is all there is to do where two meet.
  std::vector<int> newest(nodes.size(), -1);
  std::vector<int> degree(nodes.size(), 0);
  const auto follow = [&](int h, int after) {
    half_[h].counter_clockwise = after;
    half_[after].clockwise = h;
  };
  for (int h = 0; h < size(); ++h) {
    int& last = newest[half_[h].from];
    follow(h, last < 0 ? h : half_[last].counter_clockwise);
    if (last >= 0) follow(last, h);
    last = h;
    ++degree[half_[h].from];
  }
  std::vector<int> out;
  out.reserve(16);
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    if (degree[node] < 3) continue;
    out.clear();
    for (int h = newest[node]; static_cast<int>(out.size()) < degree[node]; h = half_[h].clockwise) out.push_back(h);
    std::sort(out.begin(), out.end(), [&](int a, int b) { return exact::angle_before(nodes[node], to(a), to(b)); });
    for (std::size_t i = 0; i < out.size(); ++i) follow(out[i], out[i + 1 == out.size() ? 0 : i + 1]);
  }
}

void PlanarGraph::build(const std::vector<Point>& nodes) {
  nodes_ = &nodes;
  join_coincident();
  drop_cancelled();
  order_around_nodes();
}

Int128 PlanarGraph::twice_area(const std::vector<int>& cycle) const {
  Int128 twice = 0;
  for (const int h : cycle) twice += exact::cross(from(h), to(h));
  return twice;
}

Ring PlanarGraph::ring_of(const std::vector<int>& cycle) const {
  Ring ring;
  ring.reserve(cycle.size());
  for (const int h : cycle) ring.push_back(from(h));
  return ring;
}

std::vector<Ring> simple_loops(Ring ring) {
  Ring sorted = ring;
  std::sort(sorted.begin(), sorted.end());
  std::vector<Ring> loops;
  if (std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end()) {
    loops.push_back(std::move(ring));
    return loops;
  }
  std::map<Point, std::size_t> place;
  Ring open;
  for (const Point p : ring) {
    const auto met = place.find(p);
    if (met == place.end()) {
      place.emplace(p, open.size());
      open.push_back(p);
      continue;
    }
    // Back at p: what lies between is a loop of its own, and p stays open.
    const auto start = open.begin() + static_cast<std::ptrdiff_t>(met->second);
    loops.emplace_back(start, open.end());
    for (auto it = start + 1; it != open.end(); ++it) place.erase(*it);
    open.erase(start + 1, open.end());
  }
  loops.push_back(std::move(open));
  return loops;
}

Ring from_smallest(Ring ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

namespace {

/// Where a hole's vertex that is not on the outline lies; every vertex on it means a hole that fills the outline.
bool holds(const Ring& outline, const exact::Box& box, const Ring& hole) {
  for (const Point p : hole) {
    if (!box.contains(p)) return false;
    bool on = false;
    for (std::size_t i = 0; i < outline.size() && !on; ++i) {
      const Point a = outline[i];
      const Point b = outline[i + 1 == outline.size() ? 0 : i + 1];
      on = exact::Box::of(a, b).contains(p) && side(a, b, p) == 0;
    }
    if (!on) return exact::winding(outline, p) != 0;
  }
  return false;
}

}  // namespace

std::vector<Polygon> polygons_of(std::vector<Ring> loops) {
  std::vector<Polygon> polygons;
  polygons.reserve(loops.size());
  std::vector<Ring> holes;
  for (Ring& loop : loops) {
    // The loops of one traced chain bound the same face: one outline and the holes that touch it, or holes only.
    Polygon polygon;
    std::vector<Ring> own_holes;
    for (Ring& simple : simple_loops(std::move(loop))) {
      const ExactArea enclosed = signed_area(simple);
      BRASH_EXPECTS(enclosed != ExactArea{}, simple.size(), simple.front().x, simple.front().y);
      if (enclosed > ExactArea{}) {
        BRASH_EXPECTS(polygon.outline.empty(), simple.front().x, simple.front().y);
        polygon.outline = from_smallest(std::move(simple));
      } else {
        own_holes.push_back(from_smallest(std::move(simple)));
      }
    }
    if (polygon.outline.empty()) {
      holes.insert(holes.end(), own_holes.begin(), own_holes.end());
    } else {
      polygon.holes = std::move(own_holes);
      polygons.push_back(std::move(polygon));
    }
  }
  std::sort(polygons.begin(), polygons.end(), [](const Polygon& a, const Polygon& b) {
    return a.outline.front() != b.outline.front() ? a.outline.front() < b.outline.front() : a.outline < b.outline;
  });
  if (!holes.empty()) {
    std::vector<exact::Box> boxes;
    std::vector<ExactArea> enclosed;
    for (const Polygon& polygon : polygons) {
      boxes.push_back(exact::box_of(polygon.outline));
      enclosed.push_back(signed_area(polygon.outline));
    }
    for (Ring& hole : holes) {
      int owner = -1;
      for (std::size_t i = 0; i < polygons.size(); ++i) {
        if (owner >= 0 && enclosed[i] >= enclosed[owner]) continue;
        if (holds(polygons[i].outline, boxes[i], hole)) owner = static_cast<int>(i);
      }
      BRASH_EXPECTS(owner >= 0, hole.front().x, hole.front().y);
      polygons[owner].holes.push_back(std::move(hole));
    }
  }
  for (Polygon& polygon : polygons) std::sort(polygon.holes.begin(), polygon.holes.end());
  return polygons;
}

}  // namespace brash::geometry
