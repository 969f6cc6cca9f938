// SPDX-License-Identifier: GPL-3.0-or-later
#include "planar_graph.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "brash/core/contract.hpp"

namespace brash::geometry {

void PlanarGraph::join_coincident() {
  const auto low = [](const Raw& e) { return std::min(e.from, e.to); };
  const auto high = [](const Raw& e) { return std::max(e.from, e.to); };
  // Sorted by the smaller node by counting, then the few at each node by the larger one.
  std::vector<int> begin(nodes_->size() + 1, 0);
  for (const Raw& e : raw_) ++begin[low(e) + 1];
  for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
  std::vector<int> filled(begin.begin(), begin.end() - 1);
  std::vector<Raw> sorted(raw_.size());
  for (const Raw& e : raw_) sorted[filled[low(e)]++] = e;
  raw_.swap(sorted);
  for (std::size_t node = 0; node + 1 < begin.size(); ++node) {
    if (begin[node + 1] - begin[node] < 2) continue;
    std::sort(raw_.begin() + begin[node], raw_.begin() + begin[node + 1],
              [&](const Raw& a, const Raw& b) { return high(a) < high(b); });
  }
  half_.clear();
  half_.reserve(2 * raw_.size());
  for (std::size_t i = 0; i < raw_.size();) {
    HalfEdge along{low(raw_[i]), high(raw_[i]), -1, -1, 0, 0, false};
    for (; i < raw_.size() && low(raw_[i]) == along.from && high(raw_[i]) == along.to; ++i) {
      const int sense = raw_[i].from == along.from ? 1 : -1;
      if (raw_[i].source == Source::kSheet) along.sheet = static_cast<std::int8_t>(along.sheet + sense);
      if (raw_[i].source == Source::kRegion) along.region = static_cast<std::int8_t>(along.region + sense);
      if (raw_[i].source == Source::kCrack) along.crack = true;
    }
    if (along.sheet == 0 && along.region == 0 && !along.crack) continue;
    HalfEdge against = along;
    std::swap(against.from, against.to);
    against.sheet = static_cast<std::int8_t>(-along.sheet);
    against.region = static_cast<std::int8_t>(-along.region);
    half_.push_back(along);
    half_.push_back(against);
  }
}

void PlanarGraph::order_around_nodes() {
  const std::vector<Point>& nodes = *nodes_;
  std::vector<int> begin(nodes.size() + 1, 0);
  for (const HalfEdge& h : half_) ++begin[h.from + 1];
  for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
  std::vector<int> out(half_.size());
  std::vector<int> filled(begin.begin(), begin.end() - 1);
  for (int h = 0; h < size(); ++h) out[filled[half_[h].from]++] = h;
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    const auto first = out.begin() + begin[node];
    const auto last = out.begin() + begin[node + 1];
    if (last - first > 2) {
      const Point o = nodes[node];
      std::sort(first, last, [&](int a, int b) { return exact::angle_before(o, to(a), to(b)); });
    }
    for (auto it = first; it != last; ++it) {
      const int following = it + 1 == last ? *first : *(it + 1);
      half_[*it].counter_clockwise = following;
      half_[following].clockwise = *it;
    }
  }
}

void PlanarGraph::build(const std::vector<Point>& nodes) {
  nodes_ = &nodes;
  join_coincident();
  order_around_nodes();
}

int PlanarGraph::find(int from, int to) const {
  const std::pair<int, int> key{std::min(from, to), std::max(from, to)};
  int low = 0;
  int high = size() / 2;
  while (low < high) {
    const int middle = (low + high) / 2;
    const HalfEdge& h = half_[2 * middle];
    if (std::pair{h.from, h.to} < key) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  if (2 * low == size() || std::pair{half_[2 * low].from, half_[2 * low].to} != key) return -1;
  return from < to ? 2 * low : 2 * low + 1;
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
