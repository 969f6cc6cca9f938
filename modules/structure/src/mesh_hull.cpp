// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_hull.hpp"

#include <algorithm>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "convex_bodies.hpp"
#include "frustum.hpp"
#include "triangle_mesh.hpp"

namespace brash::structure {
namespace {

/// Outlines leave out vertices that lie nearer to them than this, over the hull's extent: a millimetre of a ship.
constexpr double kOutlineError = 1e-5;
/// Sections between the lowest and the highest one, where the mesh bends between them. docs/theory/structures.md, (K1)
constexpr int kMiddleSections = 3;
/// Faces flatter than this are deck or keel: sine of half a degree.
constexpr double kFlat = 8.7e-3;

Vec3 normal_of(const std::array<Vec3, 3>& triangle) {
  const Vec3 area = vector_area(triangle);
  return norm(area) > 0.0 ? normalized(area) : Vec3{0.0, 0.0, 1.0};
}
bool is_side(Vec3 normal) { return norm(plan(normal)) > kFlat; }

std::array<Vec3, 3> in_world(const Pose& pose, const std::array<Vec3, 3>& triangle) {
  return {to_world(pose, triangle[0]), to_world(pose, triangle[1]), to_world(pose, triangle[2])};
}

/// Whether the plan of a triangle may reach into a region, and its heights into a slab. A steep face leans inwards in
/// the ice, so it may lie a little outside. Without this, a vertical face whose plan is a line misses the region of its
/// own outline where that is rounded.
bool reaches(const std::array<Vec3, 3>& t, double bottom, double top, const PlanBox& region) {
  const double lean = kLean * (top - bottom);
  const auto [x0, x1] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [y0, y1] = std::minmax({t[0].y, t[1].y, t[2].y});
  const auto [z0, z1] = std::minmax({t[0].z, t[1].z, t[2].z});
  return z1 > bottom && z0 < top && x1 >= region.lower.x - lean && x0 <= region.upper.x + lean &&
         y1 >= region.lower.y - lean && y0 <= region.upper.y + lean;
}

}  // namespace

MeshBody::MeshBody(TriangleMesh mesh, MeshReport read) : sections(std::move(mesh)), report(read) {
  ConvexBodies bodies = convex_bodies(sections.mesh());
  parts = std::move(bodies.parts);
  report.n_parts = static_cast<int>(parts.size());
  report.parts_error = bodies.error;
  report.size = box_around(sections.mesh().vertices).size();
  report.bearing = bearing_of(sections);
  tolerance = kOutlineError * norm(report.size);
}

/// Between two heights without a vertex the surface is ruled, and a point that no end covers is passed over by two
/// edges at least: the strip that the sections miss is thinner than the outlines' tolerance for all but bent faces.
Footprint MeshHull::footprint(const Pose& pose, double bottom, double top) const {
  const MeshSections& sections = body_->sections;
  const std::vector<int> near = sections.near(pose, bottom, top);
  const auto bends = [&](int t) {
    const auto triangle = in_world(pose, corners(mesh(), static_cast<std::size_t>(t)));
    return std::ranges::any_of(triangle, [&](Vec3 v) { return v.z > bottom && v.z < top; });
  };
  const int n = bottom == top ? 1 : std::ranges::any_of(near, bends) ? kMiddleSections + 2 : 2;
  std::vector<Loops> regions;
  for (int i = 0; i < n; ++i)
    regions.push_back(sections.at(pose, i == 0 ? bottom : bottom + i * (top - bottom) / (n - 1), near));
  return {united(regions, body_->tolerance), common(regions, body_->tolerance, kLean * (top - bottom))};
}

std::vector<SidePiece> MeshHull::sides(const Pose& pose, double bottom, double top, const PlanBox& region) const {
  std::vector<SidePiece> pieces;
  for (const int t : body_->sections.near(pose, bottom, top)) {
    const auto triangle = in_world(pose, corners(mesh(), static_cast<std::size_t>(t)));
    if (!reaches(triangle, bottom, top, region)) continue;
    const Vec3 normal = normal_of(triangle);
    if (!is_side(normal)) continue;
    SidePiece piece{normal, slab_of({triangle.begin(), triangle.end()}, bottom, top)};
    if (piece.outline.size() < 3) continue;
    pieces.push_back(is_steep(normal) ? leaning(piece, top) : std::move(piece));
  }
  return pieces;
}

/// In ever thicker slabs about the point, until nothing nearer can be outside.
Surface MeshHull::surface_at(const Pose& pose, Vec3 point) const {
  const TriangleMesh& all = mesh();
  for (double reach = body_->tolerance * 1e2;; reach *= 4.0) {
    const bool everywhere = reach > 2.0 * norm(body_->report.size) + norm(point - pose.position);
    double nearest = everywhere ? HUGE_VAL : reach;
    std::optional<Vec3> normal;
    for (const int t : body_->sections.near(pose, point.z - reach, point.z + reach)) {
      const auto triangle = in_world(pose, corners(all, static_cast<std::size_t>(t)));
      const Vec3 here = normal_of(triangle);
      if (!is_side(here)) continue;
      const double away = distance(point, triangle);
      if (away < nearest) nearest = away, normal = here;
    }
    if (normal) return surface_with(*normal);
    BRASH_EXPECTS(!everywhere, "the hull has no sides");
  }
}

Displacement MeshHull::displaced(const Pose& pose) const {
  std::vector<Vec3> world;
  world.reserve(mesh().vertices.size());
  for (const Vec3 v : mesh().vertices) world.push_back(to_world(pose, v));
  return displacement_of(mesh(), world);
}

}  // namespace brash::structure
