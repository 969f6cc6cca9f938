// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>

#include "arrangement.hpp"
#include "brash/core/contract.hpp"

namespace brash::geometry {

namespace {

constexpr int kUnknown = std::numeric_limits<int>::min();

}  // namespace

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
  if (!box_.contains(p)) return false;
  int turns = 0;
  for (int h = 0; h < graph_.size(); h += 2) {
    if (graph_[h].region != 0 && exact::meets_ray(graph_.from(h), graph_.to(h), p)) {
      turns += graph_[h].region * (graph_.from(h).y < graph_.to(h).y ? 1 : -1);
    }
  }
  BRASH_EXPECTS(turns == 0 || turns == 1, "the region is not simple", turns, p.x, p.y);
  return turns == 1;
}

void Arrangement::label() {
  left_.assign(graph_.size(), {kUnknown, kUnknown});
  // Outside the safe box edges are missing: what lies between two edges at a node there is no single face.
  std::vector<char> is_complete(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) is_complete[i] = safe_box_.contains(nodes_[i]) ? 1 : 0;
  std::vector<int> group;
  group.reserve(graph_.size());
  for (int h = 0; h < graph_.size(); ++h) {
    if (left_[h].ice == kUnknown) label_group(h, is_complete, group);
  }
  check_labels(is_complete);
}

/// Labels all that hangs together with `start`: first relative to the face left of it, then absolutely.
void Arrangement::label_group(int start, const std::vector<char>& is_complete, std::vector<int>& group) {
  const auto reach = [&](int h, int ice, int region) {
    if (left_[h].ice != kUnknown) return;
    left_[h] = {ice, region};
    group.push_back(h);
  };
  group.clear();
  reach(start, 0, 0);
  Cover base{kUnknown, kUnknown};  // Of the face left of `start`.
  for (std::size_t i = 0; i < group.size(); ++i) {
    const int h = group[i];
    const PlanarGraph::HalfEdge& edge = graph_[h];
    const Cover here = left_[h];
    if (edge.sheet > 0) base.ice = 1 - here.ice;
    if (edge.region > 0) base.region = 1 - here.region;
    reach(PlanarGraph::twin(h), here.ice - edge.sheet, here.region - edge.region);
    if (is_complete[edge.to]) reach(graph_.next_in_face(h), here.ice, here.region);
  }
  // A group without a free edge lies wholly in ice or in water; the same for the region.
  if (base.ice == kUnknown) base.ice = is_in_ice(graph_.from(start)) ? 1 : 0;
  if (base.region == kUnknown) base.region = is_in_region(graph_.from(start)) ? 1 : 0;
  for (const int h : group) left_[h] = {left_[h].ice + base.ice, left_[h].region + base.region};
}

/// Throws unless every label is 0 or 1, agrees with what its edge parts and is the same all round its face.
void Arrangement::check_labels(const std::vector<char>& is_complete) const {
  for (int h = 0; h < graph_.size(); ++h) {
    const PlanarGraph::HalfEdge& edge = graph_[h];
    const Cover here = left_[h];
    const Cover across = left_[PlanarGraph::twin(h)];
    const Cover next = is_complete[edge.to] ? left_[graph_.next_in_face(h)] : here;
    const bool is_binary = (here.ice == 0 || here.ice == 1) && (here.region == 0 || here.region == 1);
    const bool agrees = here.ice - across.ice == edge.sheet && here.region - across.region == edge.region &&
                        next.ice == here.ice && next.region == here.region;
    BRASH_EXPECTS(is_binary && agrees, here.ice, here.region, across.ice, across.region, next.ice, next.region,
                  graph_.from(h).x, graph_.from(h).y);
    BRASH_EXPECTS(is_complete[edge.to] || edge.region == 0, graph_.to(h).x, graph_.to(h).y);
  }
}

std::vector<Crack> cracks_inside(std::span<const Point> region, std::span<const Crack> cracks) {
  if (cracks.empty()) return {};
  std::vector<Crack> inside;
  inside.reserve(2 * cracks.size());
  Ring stops;
  stops.reserve(16);
  for (const Crack& crack : cracks) {
    stops.assign({crack.from, crack.to});
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
      if (p != q && exact::winding(region, {p.x + q.x, p.y + q.y}, 2) == 1) inside.push_back({p, q});
    }
  }
  return inside;
}

}  // namespace brash::geometry
