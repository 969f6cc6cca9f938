// SPDX-License-Identifier: GPL-3.0-or-later
#include "frustum.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "brash/core/contract.hpp"

namespace brash::structure {
namespace {

double turn(Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); }

/// The convex hull, counter-clockwise (Andrew's monotone chain); empty for fewer than three corners.
Outline convex_hull(std::vector<Vec2> points) {
  std::ranges::sort(points, {}, [](Vec2 p) { return std::tuple(p.x, p.y); });
  Outline hull;
  const auto add_chain = [&](auto first, auto last) {
    const std::size_t start = hull.size();
    for (auto p = first; p != last; ++p) {
      while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), *p) <= 0.0) hull.pop_back();
      hull.push_back(*p);
    }
    if (!hull.empty()) hull.pop_back();  // the other chain begins with it
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull.size() < 3 ? Outline{} : hull;
}

/// The part of a convex outline on the left of the line through `from` and `to`.
Outline left_of(const Outline& outline, Vec2 from, Vec2 to) {
  Outline kept;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    const double at_a = turn(from, to, a), at_b = turn(from, to, b);
    if (at_a >= 0.0) kept.push_back(a);
    if ((at_a > 0.0 && at_b < 0.0) || (at_a < 0.0 && at_b > 0.0)) kept.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return kept;
}

/// The common part of two convex outlines.
Outline intersection(Outline one, const Outline& other) {
  if (other.empty()) return {};
  for (std::size_t i = 0; i < other.size() && !one.empty(); ++i)
    one = left_of(one, other[i], other[(i + 1) % other.size()]);
  return convex_hull(std::move(one));
}

/// The part of a convex polygon at heights of at least `sign * height`, as `sign` turns the axis: 1 up, -1 down.
std::vector<Vec3> beyond(const std::vector<Vec3>& outline, double height, double sign) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec3 a = outline[i], b = outline[(i + 1) % outline.size()];
    const double at_a = sign * (a.z - height), at_b = sign * (b.z - height);
    if (at_a >= 0.0) kept.push_back(a);
    if ((at_a > 0.0 && at_b < 0.0) || (at_a < 0.0 && at_b > 0.0)) kept.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return kept;
}

TriangleMesh mesh_of(const std::vector<Vec3>& vertices) {
  TriangleMesh mesh{vertices, {}};
  const int n = static_cast<int>(vertices.size() / 2);
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    mesh.triangles.push_back({i, next, next + n});
    mesh.triangles.push_back({i, next + n, i + n});
  }
  for (int i = 1; i + 1 < n; ++i) {
    mesh.triangles.push_back({0, i + 1, i});
    mesh.triangles.push_back({n, n + i, n + i + 1});
  }
  return mesh;
}

std::vector<Vec3> in_world(const std::vector<Vec3>& vertices, const Pose& pose) {
  std::vector<Vec3> world;
  world.reserve(vertices.size());
  for (const Vec3 v : vertices) world.push_back(to_world(pose, v));
  return world;
}

}  // namespace

Frustum::Frustum(std::vector<Vec3> lower, const std::vector<Vec3>& upper) : vertices_(std::move(lower)) {
  const std::size_t n = vertices_.size();
  BRASH_EXPECTS(n >= 3 && upper.size() == n, n, upper.size());
  vertices_.insert(vertices_.end(), upper.begin(), upper.end());
  mesh_ = mesh_of(vertices_);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 a = vertices_[i], along = vertices_[(i + 1) % n] - a, up = vertices_[i + n] - a;
    const Vec3 normal = normalized(cross(along, up));
    sides_.push_back({normal, dot(normal, a)});
  }
}

/// The section of the body with the vertices `world` at the height z.
Outline Frustum::section(const std::vector<Vec3>& world, double z) const {
  std::vector<Vec2> points;
  const auto cross_edge = [&](Vec3 a, Vec3 b) {
    if ((a.z <= z) == (b.z <= z)) return;
    points.push_back(plan(a + (z - a.z) / (b.z - a.z) * (b - a)));
  };
  const std::size_t n = world.size() / 2;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    cross_edge(world[i], world[next]);
    cross_edge(world[n + i], world[n + next]);
    cross_edge(world[i], world[n + i]);
  }
  return convex_hull(std::move(points));
}

/// The union of a convex body's sections is the plan of the slab between the heights. A point in both the lowest and
/// the highest section is in all sections.
Footprint Frustum::footprint(const Pose& pose, double bottom, double top) const {
  const std::vector<Vec3> world = in_world(vertices_, pose);
  const Outline lower = section(world, bottom), upper = section(world, top);
  std::vector<Vec2> slab = lower;
  slab.insert(slab.end(), upper.begin(), upper.end());
  for (const Vec3 v : world)
    if (v.z >= bottom && v.z <= top) slab.push_back(plan(v));
  Footprint result;
  if (Outline leading = convex_hull(std::move(slab)); !leading.empty()) result.leading.push_back(std::move(leading));
  if (Outline trailing = drawn_in(intersection(lower, upper), pose, bottom, top); !trailing.empty())
    result.trailing.push_back(std::move(trailing));
  return result;
}

/// The plan of the sections between two heights, drawn in where a vertical side leans over the ice.
Outline Frustum::drawn_in(Outline outline, const Pose& pose, double bottom, double top) const {
  for (std::size_t i = 0; i < sides_.size() && !outline.empty(); ++i) {
    const Vec3 normal = rotate(pose.rotation, sides_[i].normal);
    if (!is_steep(normal)) continue;
    const Vec2 out = normalized(plan(normal));
    const double offset = sides_[i].offset + dot(normal, pose.position);
    const double line = (offset - std::max(normal.z * bottom, normal.z * top)) / norm(plan(normal));
    const Vec2 from = (line - kLean * (top - bottom)) * out;
    outline = convex_hull(left_of(outline, from, from + perpendicular(out)));
  }
  return outline;
}

std::vector<SidePiece> Frustum::sides(const Pose& pose, double bottom, double top, const PlanBox&) const {
  const std::vector<Vec3> world = in_world(vertices_, pose);
  const std::size_t n = sides_.size();
  std::vector<SidePiece> pieces;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    std::vector<Vec3> outline{world[i], world[next], world[n + next], world[n + i]};
    outline = slab_of(std::move(outline), bottom, top);
    if (outline.size() < 3) continue;
    SidePiece piece{rotate(pose.rotation, sides_[i].normal), std::move(outline)};
    pieces.push_back(is_steep(piece.normal) ? leaning(piece, top) : std::move(piece));
  }
  return pieces;
}

Surface Frustum::surface_at(const Pose& pose, Vec3 point) const {
  const Vec3 p = to_body(pose, point);
  const auto height = [&](const Side& side) { return dot(side.normal, p) - side.offset; };
  const Side& nearest = *std::ranges::max_element(sides_, {}, height);
  return surface_with(rotate(pose.rotation, nearest.normal));
}

Displacement Frustum::displaced(const Pose& pose) const { return displacement_of(mesh_, in_world(vertices_, pose)); }

SidePiece leaning(const SidePiece& piece, double top) {
  const Vec2 out = normalized(plan(piece.normal));
  const double slant = std::hypot(1.0, kLean);
  SidePiece result{{out.x / slant, out.y / slant, -kLean / slant}, {}};
  for (const Vec3 v : piece.outline) {
    const double in = kLean * (top - v.z);
    result.outline.push_back({v.x - in * out.x, v.y - in * out.y, v.z});
  }
  return result;
}

std::vector<Vec3> slab_of(std::vector<Vec3> polygon, double bottom, double top) {
  return beyond(beyond(polygon, bottom, 1.0), top, -1.0);
}

Surface surface_with(Vec3 normal) {
  return {normal, std::atan2(norm(plan(normal)), std::abs(normal.z)),
          normal.z > 0.0 ? model::Breaking::kUpward : model::Breaking::kDownward};
}

}  // namespace brash::structure
