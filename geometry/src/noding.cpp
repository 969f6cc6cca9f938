// SPDX-License-Identifier: GPL-3.0-or-later
#include "noding.hpp"

#include <algorithm>

#include "brash/core/contract.hpp"

namespace brash::geometry {

namespace {

using exact::Box;

/// Sheet edges that come this close to the region take part [grid units]; routing moves edges by less.
constexpr std::int64_t kSafeMargin = 32;
constexpr std::int64_t kGatherMargin = 64;
/// Routing is finite; a deeper recursion is a bug.
constexpr int kMaxDepth = 200;

}  // namespace

Noding::Noding(const FreeEdges& boundary, std::span<const Point> region, std::span<const Crack> cracks)
    : boundary_(boundary) {
  gather(region, cracks);
  add_crossings();
  sort_nodes();
  route_all();
}

void Noding::gather(std::span<const Point> region, std::span<const Crack> cracks) {
  box_ = exact::box_of(region);
  segments_.reserve(4 * (region.size() + cracks.size()));
  for (std::size_t i = 0; i < region.size(); ++i) {
    const Point next = region[i + 1 == region.size() ? 0 : i + 1];
    if (region[i] != next) segments_.emplace_back(region[i], next, Source::kRegion);
  }
  for (const Crack& crack : cracks) {
    box_.add(crack.from);
    box_.add(crack.to);
    if (crack.from != crack.to) segments_.emplace_back(crack.from, crack.to, Source::kCrack);
  }
  safe_box_ = box_.grown(kSafeMargin);
  gather_box_ = box_.grown(kGatherMargin);
  boundary_.query(gather_box_, [&](int id) {
    segments_.emplace_back(boundary_.edge(id).from, boundary_.edge(id).to, Source::kSheet, id);
  });
}

void Noding::add_crossings() {
  // The region's edges by their left end: the edges that can meet a given edge are consecutive.
  std::vector<const Segment*> region;
  region.reserve(segments_.size());
  crossings_.reserve(16);
  std::int64_t widest = 0;
  for (const Segment& s : segments_) {
    if (s.source != Source::kRegion) continue;
    region.push_back(&s);
    widest = std::max(widest, s.box.high.x - s.box.low.x);
  }
  const auto left_of = [](const Segment* s, std::int64_t x) { return s->box.low.x < x; };
  std::sort(region.begin(), region.end(), [&](const Segment* a, const Segment* b) { return left_of(a, b->box.low.x); });
  const auto cross = [](const Segment& a, const Segment& b) {
    return a.box.overlaps(b.box) && exact::cross_properly(a.from, a.to, b.from, b.to);
  };
  const auto add = [&](const Segment& a, const Segment& b) {
    if (cross(a, b)) crossings_.push_back(exact::rounded_crossing(a.from, a.to, b.from, b.to));
  };
  for (const Segment& s : segments_) {
    if (s.source == Source::kRegion) continue;
    auto it = std::lower_bound(region.begin(), region.end(), s.box.low.x - widest, left_of);
    for (; it != region.end() && (*it)->box.low.x <= s.box.high.x; ++it) add(s, **it);
  }
  for (std::size_t i = 0; i < region.size(); ++i) {
    const Segment& a = *region[i];
    for (std::size_t j = i + 1; j < region.size() && region[j]->box.low.x <= a.box.high.x; ++j) {
      BRASH_EXPECTS(!cross(a, *region[j]), "the region crosses itself", a.from.x, a.from.y);
    }
  }
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    if (segments_[i].source != Source::kCrack) continue;
    for (std::size_t j = 0; j < segments_.size(); ++j) {
      const bool is_later_crack = segments_[j].source == Source::kCrack && j > i;
      if (is_later_crack || segments_[j].source == Source::kSheet) add(segments_[i], segments_[j]);
    }
  }
}

void Noding::sort_nodes() {
  // Ends of segments with the place where their node's number goes; consecutive segments share one.
  struct End {
    Point at;
    int* node;
  };
  std::vector<End> ends;
  ends.reserve(2 * segments_.size() + crossings_.size());
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    Segment& s = segments_[i];
    const bool is_shared = i > 0 && s.from == segments_[i - 1].to;
    if (!is_shared) ends.push_back({s.from, &s.from_node});
    ends.push_back({s.to, &s.to_node});
  }
  for (const Point p : crossings_) ends.push_back({p, nullptr});
  std::sort(ends.begin(), ends.end(),
            [](const End& a, const End& b) { return a.at.x != b.at.x ? a.at.x < b.at.x : a.at.y < b.at.y; });
  nodes_.reserve(ends.size() + 8);
  for (std::size_t i = 0; i < ends.size();) {
    bool is_given = false;
    nodes_.push_back(ends[i].at);
    for (; i < ends.size() && ends[i].at == nodes_.back(); ++i) {
      if (ends[i].node == nullptr) continue;
      *ends[i].node = static_cast<int>(nodes_.size()) - 1;
      is_given = true;
    }
    is_rounded_.push_back(is_given ? 0 : 1);
  }
  for (std::size_t i = 1; i < segments_.size(); ++i) {
    if (segments_[i].from_node < 0) segments_[i].from_node = segments_[i - 1].to_node;
  }
  n_sorted_ = nodes_.size();
}

int Noding::add_edge(int from, int to, Source source) {
  edges_.push_back({from, to, source});
  return static_cast<int>(edges_.size()) - 1;
}

std::vector<char> Noding::nodes_without_cracks() const {
  std::vector<char> is_there(nodes_.size(), 0);
  for (const Segment& s : segments_) {
    if (s.source != Source::kCrack) is_there[s.from_node] = is_there[s.to_node] = 1;
  }
  for (std::size_t node = n_sorted_; node < nodes_.size(); ++node) is_there[node] = 1;
  return is_there;
}

int Noding::node_at(Point p) const {
  const auto sorted_end = nodes_.begin() + static_cast<std::ptrdiff_t>(n_sorted_);
  auto it = std::lower_bound(nodes_.begin(), sorted_end, p);
  if (it == sorted_end || *it != p) it = std::find(sorted_end, nodes_.end(), p);
  return it == nodes_.end() ? -1 : static_cast<int>(it - nodes_.begin());
}

/// Puts the nodes in whose pixels the edge comes on top of the targets, the nearest last.
void Noding::add_nodes_met(int from, int to, bool is_moved, int depth) {
  const Point a = nodes_[from];
  const Point b = nodes_[to];
  const Box box = Box::of(a, b);
  const auto n_before = static_cast<std::ptrdiff_t>(targets_.size());
  // Nodes are sorted by x: the nodes of the box stand between the ends, give or take nodes straight above and below.
  const int n = static_cast<int>(n_sorted_);
  int first = std::min({from, to, n});
  while (first > 0 && nodes_[first - 1].x >= box.low.x) --first;
  for (int i = first; i < n && nodes_[i].x <= box.high.x; ++i) {
    const std::int64_t y = nodes_[i].y;
    if (y < box.low.y || y > box.high.y || i == from || i == to) continue;
    if (exact::meets_pixel(a, b, nodes_[i])) targets_.push_back({i, depth});
  }
  if (is_moved && !(safe_box_.contains(a) && safe_box_.contains(b))) {
    // A moved edge may come to vertices of sheet edges that took no part so far.
    boundary_.query(box, [&](int id) {
      const Point p = boundary_.edge(id).from;
      if (p == a || p == b || !exact::meets_pixel(a, b, p)) return;
      int node = node_at(p);
      if (node < 0) {
        node = static_cast<int>(nodes_.size());
        nodes_.push_back(p);
        is_rounded_.push_back(0);
      }
      targets_.push_back({node, depth});
    });
  }
  const auto begin = targets_.begin() + n_before;
  if (targets_.end() - begin < 2) return;
  std::sort(begin, targets_.end(), [&](const Target& s, const Target& t) {
    const Int128 to_s = exact::dot(a, b, nodes_[s.node]);
    const Int128 to_t = exact::dot(a, b, nodes_[t.node]);
    return to_s != to_t ? to_s > to_t : s.node > t.node;
  });
  const auto is_same = [](const Target& s, const Target& t) { return s.node == t.node; };
  targets_.erase(std::unique(begin, targets_.end(), is_same), targets_.end());
}

/// Leads a segment through the nodes that wait as targets and those it meets on the way: `chain` holds them all, the
/// segment's ends included.
void Noding::route(const Segment& s, std::vector<int>& chain) {
  chain.assign(1, s.from_node);
  while (!targets_.empty()) {
    const Target next = targets_.back();
    const std::size_t n_targets = targets_.size();
    BRASH_EXPECTS(next.depth < kMaxDepth, s.from.x, s.from.y, s.to.x, s.to.y);
    add_nodes_met(chain.back(), next.node, true, next.depth + 1);
    if (targets_.size() > n_targets) continue;
    chain.push_back(next.node);
    targets_.pop_back();
  }
}

void Noding::route_all() {
  std::vector<int> chain;
  std::vector<int> outside;
  chain.reserve(16);
  outside.reserve(16);
  targets_.reserve(16);
  edges_.reserve(2 * segments_.size());
  active_.reserve(segments_.size());
  for (const Segment& s : segments_) {
    targets_.assign(1, {s.to_node, 0});
    add_nodes_met(s.from_node, s.to_node, false, 1);
    if (targets_.size() == 1) {
      const int edge = add_edge(s.from_node, s.to_node, s.source);
      if (s.source == Source::kSheet) active_.push_back({s.edge, s.from_node, s.to_node, edge});
      continue;
    }
    route(s, chain);
    for (std::size_t i = 1; i < chain.size(); ++i) add_edge(chain[i - 1], chain[i], s.source);
    if (s.source != Source::kSheet) continue;
    active_.push_back({s.edge, s.from_node, s.to_node, -1});
    for (std::size_t i = 1; i + 1 < chain.size(); ++i)
      if (turn(s.from, s.to, nodes_[chain[i]]) != 0) is_rounded_[chain[i]] = 1;
    twice_moved_ -= exact::cross(s.from, s.to);
    for (std::size_t i = 1; i < chain.size(); ++i) twice_moved_ += exact::cross(nodes_[chain[i - 1]], nodes_[chain[i]]);
    for (const int node : chain) {
      if (!safe_box_.contains(nodes_[node])) outside.push_back(node);
    }
  }
  activate_around(outside);
}

/// The links at a vertex can be made again only when all edges there take part.
void Noding::activate_around(const std::vector<int>& nodes) {
  std::vector<int> fresh;
  const auto add = [&](int id) {
    const Box box = Box::of(boundary_.edge(id).from, boundary_.edge(id).to);
    if (!gather_box_.overlaps(box)) fresh.push_back(id);
  };
  for (const int node : nodes) {
    for (const int out : boundary_.starting_at(nodes_[node])) {
      add(out);
      add(boundary_.edge(out).previous);
    }
  }
  std::sort(fresh.begin(), fresh.end());
  fresh.erase(std::unique(fresh.begin(), fresh.end()), fresh.end());
  const auto node_or_new = [&](Point p) {
    const int node = node_at(p);
    if (node >= 0) return node;
    nodes_.push_back(p);
    return static_cast<int>(nodes_.size()) - 1;
  };
  for (const int id : fresh) {
    const int from = node_or_new(boundary_.edge(id).from);
    const int to = node_or_new(boundary_.edge(id).to);
    active_.push_back({id, from, to, add_edge(from, to, Source::kSheet)});
  }
}

namespace {

/// The ends of all cracks, from left to right.
Ring ends_of(std::span<const Crack> cracks) {
  Ring ends;
  ends.reserve(2 * cracks.size());
  for (const Crack& crack : cracks) ends.insert(ends.end(), {crack.from, crack.to});
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

/// Adds the ends in whose pixels the crack comes. The crossing of a crack and the region is rounded, and the crack that
/// goes there may miss the pixel of another one that ends on it.
void add_ends_met(const Crack& crack, const Box& reach, const Ring& ends, Ring& stops) {
  const auto is_left = [](Point end, std::int64_t x) { return end.x < x; };
  for (auto end = std::lower_bound(ends.begin(), ends.end(), reach.low.x, is_left);
       end != ends.end() && end->x <= reach.high.x; ++end)
    if (exact::meets_pixel(crack.from, crack.to, *end)) stops.push_back(*end);
}

}  // namespace

std::vector<Crack> cracks_inside(std::span<const Point> region, std::span<const Crack> cracks) {
  if (cracks.empty()) return {};
  std::vector<Crack> inside;
  inside.reserve(2 * cracks.size());
  const Ring ends = ends_of(cracks);
  Ring stops;
  stops.reserve(16);
  for (const Crack& crack : cracks) {
    stops.assign({crack.from, crack.to});
    const exact::Box reach = exact::Box::of(crack.from, crack.to);
    add_ends_met(crack, reach, ends, stops);
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
      if (p != q && exact::winding(region, p + q, 2) == 1) inside.push_back({p, q});
    }
  }
  return inside;
}

}  // namespace brash::geometry
