// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_ways.hpp"

#include <algorithm>
#include <cmath>

namespace brash::rigid_body {
namespace {

/// Edges whose directions differ by less than this angle [rad] count as parallel: no direction is normal to both alone.
constexpr double kParallel = 1e-6;

struct Box {
  Vec3 lower;
  Vec3 upper;
};

Box grown(Vec3 lower, Vec3 upper, double by) { return {lower - Vec3{by, by, by}, upper + Vec3{by, by, by}}; }

/// One bit for each side of the box that the point lies beyond.
unsigned sides_beyond(const Box& box, Vec3 p) {
  return unsigned{p.x < box.lower.x} | unsigned{p.x > box.upper.x} << 1 | unsigned{p.y < box.lower.y} << 2 |
         unsigned{p.y > box.upper.y} << 3 | unsigned{p.z < box.lower.z} << 4 | unsigned{p.z > box.upper.z} << 5;
}

/// Without a branch until the end: which side parts two boxes is hard to foresee.
bool overlap(const Box& box, Vec3 lower, Vec3 upper) {
  return static_cast<bool>(unsigned{lower.x <= box.upper.x} & unsigned{upper.x >= box.lower.x} &
                           unsigned{lower.y <= box.upper.y} & unsigned{upper.y >= box.lower.y} &
                           unsigned{lower.z <= box.upper.z} & unsigned{upper.z >= box.lower.z});
}

}  // namespace

/// Edges that come within `reach` of the other part's box.
void EdgeWays::collect_near(const PlacedPart& part, const PlacedPart& other, double reach,
                            std::vector<PlacedEdge>& edges) {
  edges.clear();
  const Box box = grown(other.lower, other.upper, reach);
  sides_.clear();
  for (const Vec3 vertex : part.vertices) sides_.push_back(sides_beyond(box, vertex));
  for (const Edge& edge : part.part->edges) {
    const auto from = static_cast<std::size_t>(edge.from), to = static_cast<std::size_t>(edge.to);
    if ((sides_[from] & sides_[to]) != 0) continue;
    const Vec3 p = part.vertices[from], q = part.vertices[to];
    edges.push_back({.from = p,
                     .along = q - p,
                     .left = part.planes[static_cast<std::size_t>(edge.left)].normal,
                     .right = part.planes[static_cast<std::size_t>(edge.right)].normal,
                     .lower = {std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)},
                     .upper = {std::max(p.x, q.x), std::max(p.y, q.y), std::max(p.z, q.z)}});
  }
}

void EdgeWays::try_pair(const PlacedEdge& e, const PlacedEdge& f, double limit) {
  // The normals beside each edge lie on both sides of the plane normal to the other edge.
  if (dot(f.left, e.along) * dot(f.right, e.along) >= 0.0) return;
  if (dot(e.left, f.along) * dot(e.right, f.along) >= 0.0) return;
  Vec3 normal = cross(e.along, f.along);
  if (dot(normal, f.left + f.right) < 0.0) normal = -normal;
  if (dot(normal, e.left + e.right) >= 0.0) return;  // both edges are the last of their parts the same way
  const double length = norm(normal);
  if (length <= kParallel * norm(e.along) * norm(f.along)) return;
  normal = normal / length;
  const double depth = dot(normal, f.from - e.from);
  if (depth < limit) ways_.push_back({normal, depth});
}

std::span<const WayOut> EdgeWays::find(const PlacedPart& a, const PlacedPart& b, double limit) {
  ways_.clear();
  collect_near(a, b, limit, edges_a_);
  if (edges_a_.empty()) return ways_;
  collect_near(b, a, limit, edges_b_);
  for (const PlacedEdge& e : edges_a_) {
    const Box box = grown(e.lower, e.upper, limit);
    for (const PlacedEdge& f : edges_b_)
      if (overlap(box, f.lower, f.upper)) try_pair(e, f, limit);
  }
  std::sort(ways_.begin(), ways_.end(), [](const WayOut& p, const WayOut& q) { return p.depth < q.depth; });
  return ways_;
}

}  // namespace brash::rigid_body
