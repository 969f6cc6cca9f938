// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_axes.hpp"

#include <algorithm>

namespace brash::rigid_body {
namespace {

/// Edges whose directions differ by less than this angle [rad] count as parallel: no direction is normal to both alone.
constexpr double kParallel = 1e-6;

/// Whether boxes overlap, without a branch until the end: which side parts them is hard to foresee.
bool boxes_overlap(Vec3 lower, Vec3 upper, Vec3 other_lower, Vec3 other_upper) {
  return static_cast<bool>(unsigned{other_lower.x <= upper.x} & unsigned{other_upper.x >= lower.x} &
                           unsigned{other_lower.y <= upper.y} & unsigned{other_upper.y >= lower.y} &
                           unsigned{other_lower.z <= upper.z} & unsigned{other_upper.z >= lower.z});
}

}  // namespace

/// Edges that no plane of the other part keeps farther from it than `reach`.
void EdgeAxes::collect_near(const PlacedPart& part, const Heights& heights, double reach,
                            std::vector<PlacedEdge>& edges) {
  edges.clear();
  beyond_.assign(heights, reach);
  for (const Edge& edge : part.part->edges) {
    const auto from = static_cast<std::size_t>(edge.from), to = static_cast<std::size_t>(edge.to);
    if (beyond_.both(from, to)) continue;
    const Vec3 p = part.vertices[from], q = part.vertices[to];
    edges.push_back({.from = p,
                     .along = q - p,
                     .left = part.planes[static_cast<std::size_t>(edge.left)].normal,
                     .right = part.planes[static_cast<std::size_t>(edge.right)].normal,
                     .lower = {std::min(p.x, q.x), std::min(p.y, q.y), std::min(p.z, q.z)},
                     .upper = {std::max(p.x, q.x), std::max(p.y, q.y), std::max(p.z, q.z)}});
  }
}

void EdgeAxes::try_pair(const PlacedEdge& e, const PlacedEdge& f, double limit) {
  // The normals beside each edge lie on both sides of the plane normal to the other edge.
  if (dot(f.left, e.along) * dot(f.right, e.along) >= 0.0) return;
  if (dot(e.left, f.along) * dot(e.right, f.along) >= 0.0) return;
  Vec3 normal = cross(e.along, f.along);
  if (dot(normal, f.left + f.right) < 0.0) normal = -normal;
  if (dot(normal, e.left + e.right) >= 0.0) return;  // both edges are the last of their parts on the same side
  const double length = norm(normal);
  if (length <= kParallel * norm(e.along) * norm(f.along)) return;
  normal = normal / length;
  const double depth = dot(normal, f.from - e.from);
  if (depth < limit) axes_.push_back({normal, depth});
}

std::span<const SeparatingAxis> EdgeAxes::find(const OverlapFinder& overlap, const PlacedPart& a, const PlacedPart& b,
                                               double limit) {
  axes_.clear();
  collect_near(a, overlap.heights_of_a(), limit, edges_a_);
  if (edges_a_.empty()) return axes_;
  collect_near(b, overlap.heights_of_b(), limit, edges_b_);
  const Vec3 reach{limit, limit, limit};
  for (const PlacedEdge& e : edges_a_) {
    const Vec3 lower = e.lower - reach, upper = e.upper + reach;
    for (const PlacedEdge& f : edges_b_)
      if (boxes_overlap(lower, upper, f.lower, f.upper)) try_pair(e, f, limit);
  }
  std::sort(axes_.begin(), axes_.end(),
            [](const SeparatingAxis& p, const SeparatingAxis& q) { return p.depth < q.depth; });
  return axes_;
}

}  // namespace brash::rigid_body
