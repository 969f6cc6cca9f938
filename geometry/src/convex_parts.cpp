// SPDX-License-Identifier: GPL-3.0-or-later
// Convex parts: bridge the holes, clip ears, merge triangles (Hertel, Mehlhorn: Fast triangulation of simple polygons,
// 1983). All tests are signs of exact integers, and every part's vertices are vertices of the polygon.
#include <algorithm>
#include <array>
#include <utility>

#include "brash/core/contract.hpp"
#include "region_loops.hpp"

namespace brash::geometry {
namespace {

using Triangle = std::array<int, 3>;

/// Starts that are tried times vertices squared: ten vertices from every start, 23 and more from one.
constexpr std::size_t kStartEffort = 1024;

Int128 twice_area(const std::vector<Point>& points, const Loop& loop) {
  Int128 sum = 0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) sum += turn(points[loop[0]], points[loop[i]], points[loop[i + 1]]);
  return sum;
}

Int128 squared_distance(Point a, Point b) {
  const Int128 x = a.x - b.x, y = a.y - b.y;
  return x * x + y * y;
}

/// True when `p` lies inside the loop; `p` is not on it. Counts the edges crossed by the ray towards +x.
bool is_inside(const std::vector<Point>& points, const Loop& loop, Point p) {
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point a = points[loop[i]], b = points[loop[(i + 1) % loop.size()]];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if ((turn(a, b, p) > 0) == (b.y > a.y)) inside = !inside;
  }
  return inside;
}

/// Neighbours of position `i` in a closed loop.
std::size_t before(const Loop& loop, std::size_t i) { return i == 0 ? loop.size() - 1 : i - 1; }
std::size_t after(const Loop& loop, std::size_t i) { return i + 1 == loop.size() ? 0 : i + 1; }

bool sees(const std::vector<Point>& points, const Loop& loop, std::size_t i, Point target) {
  return is_in_sector(points[loop[before(loop, i)]], points[loop[i]], points[loop[after(loop, i)]], target);
}

/// True when an edge of the loop crosses the segment `a`-`b` or has an end inside it.
bool blocks(const std::vector<Point>& points, const Loop& loop, Point a, Point b) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point p = points[loop[i]], q = points[loop[after(loop, i)]];
    if (p != a && p != b && is_on_segment(p, a, b)) return true;
    if (side(a, b, p) * side(a, b, q) < 0 && side(p, q, a) * side(p, q, b) < 0) return true;
  }
  return false;
}

/// Joins holes[which] to the outline by the shortest diagonal that meets nothing else: there and back again.
void bridge(const std::vector<Point>& points, Loop& outline, const std::vector<Loop>& holes, std::size_t which) {
  struct Candidate {
    Int128 length;
    std::size_t at_hole;
    std::size_t at_outline;
  };
  const Loop& hole = holes[which];
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < hole.size(); ++i) {
    for (std::size_t j = 0; j < outline.size(); ++j) {
      const Point h = points[hole[i]], o = points[outline[j]];
      if (sees(points, hole, i, o) && sees(points, outline, j, h)) candidates.push_back({squared_distance(h, o), i, j});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.length < b.length; });
  for (const Candidate& c : candidates) {
    const Point h = points[hole[c.at_hole]], o = points[outline[c.at_outline]];
    if (blocks(points, outline, h, o)) continue;
    if (std::any_of(holes.begin() + which, holes.end(), [&](const Loop& l) { return blocks(points, l, h, o); }))
      continue;
    Loop detour(hole.begin() + c.at_hole, hole.end());
    detour.insert(detour.end(), hole.begin(), hole.begin() + c.at_hole + 1);
    detour.push_back(outline[c.at_outline]);
    outline.insert(outline.begin() + c.at_outline + 1, detour.begin(), detour.end());
    return;
  }
  BRASH_EXPECTS(false, "a hole sees no vertex of its outline: the polygon is not valid", points[hole[0]].x,
                points[hole[0]].y);
}

/// One loop without holes for each connected part of the region.
std::vector<Loop> simply_connected(const RegionLoops& region) {
  const std::vector<Point>& points = region.points;
  std::vector<Loop> outlines, holes;
  for (const Loop& loop : region.loops) (twice_area(points, loop) > 0 ? outlines : holes).push_back(loop);

  // In this order each hole sees a vertex of its outline to its right, whatever holes are still to come.
  const auto rightmost = [](const Loop& loop) { return *std::max_element(loop.begin(), loop.end()); };
  std::sort(holes.begin(), holes.end(), [&](const Loop& a, const Loop& b) { return rightmost(a) > rightmost(b); });

  std::vector<std::vector<Loop>> holes_of(outlines.size());
  for (const Loop& hole : holes) {
    std::size_t owner = outlines.size();
    for (std::size_t i = 0; i < outlines.size(); ++i) {
      if (!is_inside(points, outlines[i], points[hole[0]])) continue;
      if (owner == outlines.size() || twice_area(points, outlines[i]) < twice_area(points, outlines[owner])) owner = i;
    }
    BRASH_EXPECTS(owner < outlines.size(), "a hole lies outside", points[hole[0]].x, points[hole[0]].y);
    holes_of[owner].push_back(hole);
  }
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    for (std::size_t k = 0; k < holes_of[i].size(); ++k) bridge(points, outlines[i], holes_of[i], k);
  }
  return outlines;
}

/// True when the triangle at position `i` can be cut off the loop by a diagonal.
bool is_ear(const std::vector<Point>& points, const Loop& loop, std::size_t i) {
  const std::size_t before_i = before(loop, i), after_i = after(loop, i);
  const int ia = loop[before_i], ib = loop[i], ic = loop[after_i];
  const Point a = points[ia], b = points[ib], c = points[ic];
  if (turn(a, b, c) <= 0) return false;

  // The diagonal leaves both its ends through the inside, or closes the loop along an edge that is there already.
  if (loop[before(loop, before_i)] != ic && !sees(points, loop, before_i, c)) return false;
  if (loop[after(loop, after_i)] != ia && !sees(points, loop, after_i, a)) return false;

  return std::none_of(loop.begin(), loop.end(), [&](int v) {
    if (v == ia || v == ib || v == ic) return false;
    const Point p = points[v];
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
  });
}

/// Takes out position `i`, and then every spike that is left there: an edge and the same edge back.
std::size_t clip(Loop& loop, std::size_t i) {
  loop.erase(loop.begin() + i);
  i %= loop.size();
  for (int tries = 0; tries < 2 && loop.size() > 2; ++tries) {
    for (const std::size_t tip : {before(loop, i), i}) {
      if (loop.size() < 3 || loop[before(loop, tip)] != loop[after(loop, tip)]) continue;
      const std::size_t second = after(loop, tip);
      loop.erase(loop.begin() + std::max(tip, second));
      loop.erase(loop.begin() + std::min(tip, second));
      i = loop.empty() ? 0 : tip % loop.size();
      tries = -1;
      break;
    }
  }
  return i;
}

/// Clips ears in the order of the loop, from position `start` on.
std::vector<Triangle> triangles_of(const std::vector<Point>& points, Loop loop, std::size_t start) {
  std::vector<Triangle> triangles;
  triangles.reserve(loop.size());
  std::size_t i = start, misses = 0;
  while (loop.size() > 3) {
    BRASH_EXPECTS(misses < loop.size(), "a loop has no ear: the polygon is not valid", points[loop[0]].x,
                  points[loop[0]].y);
    if (!is_ear(points, loop, i)) {
      i = after(loop, i);
      ++misses;
      continue;
    }
    triangles.push_back({loop[before(loop, i)], loop[i], loop[after(loop, i)]});
    i = clip(loop, i);
    misses = 0;
  }
  if (loop.size() == 3) triangles.push_back({loop[0], loop[1], loop[2]});
  return triangles;
}

/// Triangles as half-edges, 3 a triangle; parts are the cycles of `next`.
class Mesh {
 public:
  Mesh(const std::vector<Point>& points, const std::vector<Triangle>& triangles) : points_(points) {
    for (const Triangle& t : triangles) {
      const int first = static_cast<int>(edges_.size());
      for (int k = 0; k < 3; ++k) edges_.push_back({t[k], first + (k + 1) % 3, first + (k + 2) % 3, true});
    }
  }

  /// Takes out every diagonal that no reflex vertex needs, in the order in which the ears were clipped.
  void merge() {
    const int n = static_cast<int>(edges_.size());
    const auto key = [&](int e) { return std::pair(edges_[e].from, to(e)); };
    std::vector<std::pair<std::pair<int, int>, int>> by_ends;
    by_ends.reserve(edges_.size());
    for (int e = 0; e < n; ++e) by_ends.push_back({key(e), e});
    std::sort(by_ends.begin(), by_ends.end());

    // Twins before anything is taken out: afterwards the ends of what is left stay the same, but not of what went.
    std::vector<std::pair<int, int>> diagonals;
    for (int e = 0; e < n; ++e) {
      const std::pair opposite(to(e), edges_[e].from);
      if (opposite.first < opposite.second) continue;
      const auto it = std::lower_bound(by_ends.begin(), by_ends.end(), std::pair(opposite, 0));
      if (it != by_ends.end() && it->first == opposite) diagonals.push_back({e, it->second});
    }
    for (const auto& [e, twin] : diagonals) {
      if (!is_needed(e, twin)) remove(e, twin);
    }
  }

  /// Takes the parts out of the mesh.
  std::vector<Ring> parts() {
    std::vector<Ring> parts;
    for (std::size_t start = 0; start < edges_.size(); ++start) {
      if (!edges_[start].is_alive) continue;
      Ring part;
      for (int e = static_cast<int>(start); edges_[e].is_alive; e = edges_[e].next) {
        edges_[e].is_alive = false;
        part.push_back(points_[edges_[e].from]);
      }
      parts.push_back(std::move(part));
    }
    return parts;
  }

 private:
  struct HalfEdge {
    int from;
    int next;
    int previous;
    bool is_alive;
  };

  int to(int e) const { return edges_[edges_[e].next].from; }
  /// True when the part would turn right where the diagonal starts.
  bool turns_right_without(int e, int twin) const {
    return turn(points_[edges_[edges_[e].previous].from], points_[edges_[e].from], points_[to(edges_[twin].next)]) < 0;
  }
  bool is_needed(int e, int twin) const { return turns_right_without(e, twin) || turns_right_without(twin, e); }
  void link(int e, int next) {
    edges_[e].next = next;
    edges_[next].previous = e;
  }
  void remove(int e, int twin) {
    link(edges_[e].previous, edges_[twin].next);
    link(edges_[twin].previous, edges_[e].next);
    edges_[e].is_alive = edges_[twin].is_alive = false;
  }

  const std::vector<Point>& points_;
  std::vector<HalfEdge> edges_;
};

/// The fewest parts of a loop that a few starts of the clipping give.
std::vector<Ring> parts_of(const std::vector<Point>& points, const Loop& loop) {
  std::size_t n_reflex = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    n_reflex += turn(points[loop[before(loop, i)]], points[loop[i]], points[loop[after(loop, i)]]) < 0;
  }
  // A diagonal mends two reflex vertices at most.
  const std::size_t at_least = (n_reflex + 1) / 2 + 1;
  const std::size_t n_starts = std::clamp<std::size_t>(kStartEffort / (loop.size() * loop.size()), 1, loop.size());

  std::vector<Ring> best;
  for (std::size_t k = 0; k < n_starts && (best.empty() || best.size() > at_least); ++k) {
    Mesh mesh(points, triangles_of(points, loop, k * loop.size() / n_starts));
    mesh.merge();
    std::vector<Ring> parts = mesh.parts();
    if (best.empty() || parts.size() < best.size()) best = std::move(parts);
  }
  return best;
}

}  // namespace

std::vector<Ring> convex_parts(const Polygon& polygon) {
  if (polygon.holes.empty() && is_convex(polygon.outline)) return {polygon.outline};

  const RegionLoops region = region_loops(polygon);
  std::vector<Ring> parts;
  for (const Loop& loop : simply_connected(region)) {
    for (Ring& part : parts_of(region.points, loop)) parts.push_back(std::move(part));
  }

  ExactArea sum;
  for (const Ring& part : parts) sum += signed_area(part);
  BRASH_EXPECTS(sum == area(polygon), sum.to_string(), area(polygon).to_string());
  return parts;
}

}  // namespace brash::geometry
