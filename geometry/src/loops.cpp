// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <utility>

#include "brash/core/contract.hpp"
#include "ice_sheet_impl.hpp"

namespace brash::geometry {

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
    // Back at p: the points between are a loop of their own, and p stays open.
    const auto start = open.begin() + static_cast<std::ptrdiff_t>(met->second);
    loops.emplace_back(start, open.end());
    for (auto it = start + 1; it != open.end(); ++it) place.erase(*it);
    open.erase(start + 1, open.end());
  }
  loops.push_back(std::move(open));
  return loops;
}

namespace {

/// `ring` started at its smallest vertex.
Ring from_smallest(Ring ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

}  // namespace

Polygon polygon_of(const std::vector<Ring>& boundary) {
  Polygon polygon;
  for (const Ring& loop : boundary) {
    for (Ring& simple : simple_loops(loop)) {
      const ExactArea enclosed = signed_area(simple);
      BRASH_EXPECTS(enclosed != ExactArea{}, simple.size(), simple.front().x, simple.front().y);
      if (enclosed < ExactArea{}) {
        polygon.holes.push_back(from_smallest(std::move(simple)));
      } else {
        BRASH_EXPECTS(polygon.outline.empty(), simple.front().x, simple.front().y);
        polygon.outline = from_smallest(std::move(simple));
      }
    }
  }
  std::sort(polygon.holes.begin(), polygon.holes.end());
  return polygon;
}

}  // namespace brash::geometry
