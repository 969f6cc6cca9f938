// SPDX-License-Identifier: GPL-3.0-or-later
#include "free_edges.hpp"

#include "brash/core/contract.hpp"
#include "predicates.hpp"

namespace brash::geometry {

using exact::Box;

std::vector<int> FreeEdges::starting_at(Point p) const {
  std::vector<int> ids;
  index_.query(Box{p, p}, [&](int id) {
    if (edges_[id].from == p) ids.push_back(id);
  });
  std::sort(ids.begin(), ids.end());
  return ids;
}

int FreeEdges::first_right_of(Point p, std::span<const int> ignored) const {
  int best = -1;
  index_.walk_right(p, [&](int id) {
    const Edge& e = edges_[id];
    if (!exact::meets_ray(e.from, e.to, p) || std::binary_search(ignored.begin(), ignored.end(), id)) return false;
    if (best < 0 || (best != id && exact::is_met_before(e.from, e.to, edges_[best].from, edges_[best].to))) best = id;
    return true;
  });
  return best;
}

bool FreeEdges::is_inside(Point p) const {
  const int id = first_right_of(p);
  return id >= 0 && edges_[id].from.y < edges_[id].to.y;
}

bool FreeEdges::is_on_boundary(Point p) const {
  bool on = false;
  query(Box{p, p}, [&](int id) { on = on || side(edges_[id].from, edges_[id].to, p) == 0; });
  return on;
}

int FreeEdges::add_edge(const Directed& directed) {
  int id = static_cast<int>(edges_.size());
  if (free_edges_.empty()) {
    edges_.emplace_back();
  } else {
    id = free_edges_.back();
    free_edges_.pop_back();
  }
  edges_[id] = {directed.from, directed.to, -1, -1, -1, 0};
  index_.insert(id, directed.from, directed.to);
  twice_area_ += exact::cross(directed.from, directed.to);
  ++n_edges_;
  return id;
}

void FreeEdges::free_edge(int id) {
  Edge& e = edges_[id];
  index_.remove(id, e.from, e.to);
  twice_area_ -= exact::cross(e.from, e.to);
  e = Edge{};
  free_edges_.push_back(id);
  --n_edges_;
}

std::optional<FreeEdges::Directed> FreeEdges::straighten(Point vertex) {
  const std::vector<int> starting = starting_at(vertex);
  if (starting.size() != 1) return std::nullopt;
  const int second = starting.front(), first = edges_[second].previous;
  const Point from = edges_[first].from, to = edges_[second].to;
  if (from == to || !exact::meets_pixel(from, to, vertex)) return std::nullopt;
  Loop& loop = loops_[edges_[first].loop];
  const Int128 area = loop.twice_area - turn(from, vertex, to);
  if (area == 0 || (area > 0) != (loop.twice_area > 0)) return std::nullopt;
  bool is_free = true;
  query(Box::of(from, to), [&](int id) {
    const Edge& other = edges_[id];
    const auto meets = [&](Point p) { return p != from && p != to && exact::meets_pixel(from, to, p); };
    if (id == first || id == second) return;
    is_free = is_free && !meets(other.from) && !meets(other.to) && (other.from != to || other.to != from) &&
              !exact::cross_properly(from, to, other.from, other.to);
  });
  if (!is_free) return std::nullopt;
  const int next = edges_[second].next;
  loop = {first, loop.n_edges - 1, area};
  free_edge(second);
  index_.remove(first, from, vertex);
  index_.insert(first, from, to);
  twice_area_ += exact::cross(from, to) - exact::cross(from, vertex);
  edges_[first].to = to;
  edges_[first].next = next;
  edges_[next].previous = first;
  return Directed{from, to};
}

int FreeEdges::add_loop() {
  if (free_loops_.empty()) {
    loops_.emplace_back();
    return static_cast<int>(loops_.size()) - 1;
  }
  const int loop = free_loops_.back();
  free_loops_.pop_back();
  loops_[loop] = Loop{};
  return loop;
}

Ring FreeEdges::ring_of(int loop) const {
  Ring ring;
  ring.reserve(loops_[loop].n_edges);
  int id = loops_[loop].edge;
  do {
    ring.push_back(edges_[id].from);
    id = edges_[id].next;
  } while (id != loops_[loop].edge);
  return ring;
}

Ring FreeEdges::take_loop(int loop) {
  Ring ring = ring_of(loop);
  int id = loops_[loop].edge;
  for (std::int64_t i = loops_[loop].n_edges; i > 0; --i) {
    const int next = edges_[id].next;
    free_edge(id);
    id = next;
  }
  if (loops_[loop].twice_area > 0) --n_outlines_;
  loops_[loop] = Loop{};
  free_loops_.push_back(loop);
  return ring;
}

int FreeEdges::outline_of(int loop) const {
  while (loops_[loop].twice_area < 0) {
    // Right of a hole's rightmost vertex lies the ice of its part, and the next edge there bounds the same part.
    int id = loops_[loop].edge;
    Point rightmost = edges_[id].from;
    for (std::int64_t i = loops_[loop].n_edges; i > 0; --i) {
      rightmost = std::max(rightmost, edges_[id].from);
      id = edges_[id].next;
    }
    const int hit = first_right_of(rightmost);
    BRASH_EXPECTS(hit >= 0 && edges_[hit].loop != loop, rightmost.x, rightmost.y);
    loop = edges_[hit].loop;
  }
  return loop;
}

void FreeEdges::check_loops() const {
  std::size_t n = 0;
  std::size_t outlines = 0;
  Int128 twice = 0;
  for (std::size_t k = 0; k < loops_.size(); ++k) {
    if (loops_[k].edge < 0) continue;
    std::int64_t length = 0;
    Int128 loop_twice = 0;
    int id = loops_[k].edge;
    do {
      const Edge& e = edges_[id];
      BRASH_EXPECTS(e.loop == static_cast<int>(k) && e.from != e.to, e.loop, k, e.from.x, e.from.y);
      BRASH_EXPECTS(edges_[e.next].from == e.to && edges_[e.next].previous == id, e.to.x, e.to.y);
      loop_twice += exact::cross(e.from, e.to);
      ++length;
      id = e.next;
    } while (id != loops_[k].edge && length <= static_cast<std::int64_t>(n_edges_));
    BRASH_EXPECTS(length == loops_[k].n_edges && loop_twice == loops_[k].twice_area, k, length, loops_[k].n_edges);
    BRASH_EXPECTS(loop_twice != 0, k, length);
    n += static_cast<std::size_t>(length);
    twice += loop_twice;
    if (loop_twice > 0) ++outlines;
  }
  BRASH_EXPECTS(n == n_edges_ && twice == twice_area_ && outlines == n_outlines_, n, n_edges_, outlines, n_outlines_);
}

void FreeEdges::check_nodes() const {
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Edge& a = edges_[i];
    if (a.loop < 0) continue;
    query(Box::of(a.from, a.to), [&](int j) {
      const Edge& b = edges_[j];
      if (static_cast<int>(i) == j) return;
      const bool coincide = (a.from == b.from && a.to == b.to) || (a.from == b.to && a.to == b.from);
      const bool met = b.from != a.from && b.from != a.to && exact::meets_pixel(a.from, a.to, b.from);
      const bool cross = exact::cross_properly(a.from, a.to, b.from, b.to);
      BRASH_EXPECTS(!coincide && !met && !cross, coincide, met, cross, a.from.x, a.from.y, a.to.x, a.to.y, b.from.x,
                    b.from.y, b.to.x, b.to.y);
    });
  }
}

}  // namespace brash::geometry
