// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "arrangement.hpp"
#include "brash/core/contract.hpp"

namespace brash::geometry {

namespace {

constexpr std::int8_t kUnknown = -128;

}  // namespace

/// Carries the label left of the half-edges in `known` over twins and around nodes to all that hang together.
void Arrangement::spread(std::vector<std::int8_t>& left, std::vector<int>& known, bool for_sheet) const {
  const auto set = [&](int h, int value) {
    BRASH_EXPECTS(value == 0 || value == 1, for_sheet, value, graph_.from(h).x, graph_.from(h).y);
    if (left[h] == kUnknown) {
      left[h] = static_cast<std::int8_t>(value);
      known.push_back(h);
    }
    BRASH_EXPECTS(left[h] == value, for_sheet, value, graph_.from(h).x, graph_.from(h).y);
  };
  while (!known.empty()) {
    const int h = known.back();
    known.pop_back();
    const int across = PlanarGraph::twin(h);
    set(across, left[h] - (for_sheet ? graph_[h].sheet : graph_[h].region));
    // The sector left of h at its origin is right of the next half-edge there. Outside the safe box edges are missing.
    if (safe_box_.contains(graph_.from(h))) set(PlanarGraph::twin(graph_[h].counter_clockwise), left[h]);
    if (safe_box_.contains(graph_.to(h))) set(graph_[across].clockwise, left[h]);
  }
}

bool Arrangement::is_in_ice(Point p) const {
  // Against the edges as they are now: those that took part may have moved or cancelled each other.
  std::vector<int> ignored;
  for (const ActiveEdge& e : active_) ignored.push_back(e.id);
  std::sort(ignored.begin(), ignored.end());
  const int hit = boundary_.first_right_of(p, ignored);
  FreeEdges::Directed first;
  bool has_hit = hit >= 0;
  if (has_hit) first = {boundary_.edge(hit).from, boundary_.edge(hit).to};
  for (int h = 0; h < graph_.size(); ++h) {
    if (graph_[h].sheet <= 0 || !exact::meets_ray(graph_.from(h), graph_.to(h), p)) continue;
    if (has_hit && !exact::is_met_before(graph_.from(h), graph_.to(h), first.from, first.to)) continue;
    has_hit = true;
    first = {graph_.from(h), graph_.to(h)};
  }
  return has_hit && first.from.y < first.to.y;
}

bool Arrangement::is_in_region(Point p) const {
  // Against the region's boundary as it was led through the nodes; stretches that ran back on themselves are gone.
  int turns = 0;
  for (int h = 0; h < graph_.size(); ++h) {
    if (graph_[h].region > 0 && exact::meets_ray(graph_.from(h), graph_.to(h), p)) {
      turns += graph_[h].region * (graph_.from(h).y < graph_.to(h).y ? 1 : -1);
    }
  }
  BRASH_EXPECTS(turns == 0 || turns == 1, "the region is not simple", turns, p.x, p.y);
  return turns == 1;
}

void Arrangement::label() {
  sheet_left_.assign(graph_.size(), kUnknown);
  region_left_.assign(graph_.size(), kUnknown);
  std::vector<int> sheet_known;
  std::vector<int> region_known;
  sheet_known.reserve(2 * graph_.size());
  region_known.reserve(2 * graph_.size());
  for (int h = 0; h < graph_.size(); ++h) {
    if (graph_[h].sheet != 0) {
      sheet_left_[h] = graph_[h].sheet > 0 ? 1 : 0;
      sheet_known.push_back(h);
    }
    const bool leaves = !safe_box_.contains(graph_.from(h)) || !safe_box_.contains(graph_.to(h));
    if (graph_[h].region != 0 || leaves) {
      BRASH_EXPECTS(graph_[h].region == 0 || !leaves, graph_.from(h).x, graph_.from(h).y);
      region_left_[h] = graph_[h].region > 0 ? 1 : 0;
      region_known.push_back(h);
    }
  }
  spread(sheet_left_, sheet_known, true);
  spread(region_left_, region_known, false);
  // What hangs together with no sheet edge lies wholly in ice or in water; the same for the region.
  for (int h = 0; h < graph_.size(); ++h) {
    if (sheet_left_[h] == kUnknown) {
      sheet_left_[h] = is_in_ice(graph_.from(h)) ? 1 : 0;
      sheet_known.push_back(h);
      spread(sheet_left_, sheet_known, true);
    }
    if (region_left_[h] == kUnknown) {
      region_left_[h] = is_in_region(graph_.from(h)) ? 1 : 0;
      region_known.push_back(h);
      spread(region_left_, region_known, false);
    }
  }
}

std::vector<Crack> cracks_inside(std::span<const Point> region, std::span<const Crack> cracks) {
  if (cracks.empty()) return {};
  // In doubled coordinates the middle of two grid points is one too.
  Ring doubled;
  doubled.reserve(region.size());
  for (const Point p : region) doubled.push_back({2 * p.x, 2 * p.y});
  std::vector<Crack> inside;
  for (const Crack& crack : cracks) {
    Ring stops{crack.from, crack.to};
    const exact::Box reach = exact::Box::of(crack.from, crack.to);
    for (std::size_t i = 0; i < region.size(); ++i) {
      const Point a = region[i];
      const Point b = region[i + 1 == region.size() ? 0 : i + 1];
      if (!reach.overlaps(exact::Box::of(a, b))) continue;
      if (exact::meets_pixel(crack.from, crack.to, a)) stops.push_back(a);
      if (exact::cross_properly(crack.from, crack.to, a, b)) {
        stops.push_back(exact::rounded_crossing(crack.from, crack.to, a, b));
      }
    }
    std::sort(stops.begin(), stops.end(), [&](Point p, Point q) {
      const Int128 dp = exact::dot(crack.from, crack.to, p);
      const Int128 dq = exact::dot(crack.from, crack.to, q);
      return dp != dq ? dp < dq : p < q;
    });
    for (std::size_t i = 1; i < stops.size(); ++i) {
      const Point p = stops[i - 1];
      const Point q = stops[i];
      if (p != q && exact::winding(doubled, {p.x + q.x, p.y + q.y}) == 1) inside.push_back({p, q});
    }
  }
  return inside;
}

}  // namespace brash::geometry
