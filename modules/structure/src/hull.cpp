// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/structure/hull.hpp"

#include <algorithm>

#include "brash/core/contract.hpp"
#include "frustum.hpp"
#include "legs.hpp"
#include "mesh_hull.hpp"
#include "triangle_mesh.hpp"

namespace brash::structure {
namespace {

std::unique_ptr<const Hull> hull_of(const model::Cone& cone) { return std::make_unique<Cone>(cone); }

}  // namespace

std::unique_ptr<const Hull> make_hull(const model::Shape& shape) {
  return std::visit([](const auto& kind) { return hull_of(kind); }, shape);
}

std::unique_ptr<const Hull> make_hull(const model::StructureSection& structure) {
  if (structure.legs.empty()) return make_hull(structure.shape);
  return std::make_unique<Legs>(make_hull(structure.shape), structure.legs);
}

std::pair<Vec3, Vec3> Hull::bounds() const {
  const Box box = box_around(mesh().vertices);
  return {box.least, box.most};
}

double Hull::reach() const {
  double farthest = 0.0;
  for (const Vec3 v : mesh().vertices) farthest = std::max(farthest, norm(v));
  return farthest;
}

/// In the middle of the vertices that reach as far, so that a straight front is met in its middle; of several outlines
/// that do, the first counts.
Foremost foremost(const Hull& hull, const Pose& pose, double bottom, double top, Vec2 course) {
  constexpr double kAsFar = 1e-6;  // [m]
  const Vec2 ahead = normalized(course);
  const auto reach_of = [ahead](const Outline& outline) {
    double reach = -HUGE_VAL;
    for (const Vec2 v : outline) reach = std::max(reach, dot(ahead, v));
    return reach;
  };
  std::vector<Outline> outlines = hull.footprint(pose, bottom, top).leading;
  BRASH_EXPECTS(!outlines.empty(), bottom, top);
  double reach = -HUGE_VAL;
  for (const Outline& outline : outlines) reach = std::max(reach, reach_of(outline));
  Outline& vertices =
      *std::ranges::find_if(outlines, [&](const Outline& outline) { return reach_of(outline) >= reach - kAsFar; });
  std::erase_if(vertices, [&](Vec2 v) { return dot(ahead, v) < reach - kAsFar; });
  Vec2 sum{};
  for (const Vec2 v : vertices) sum += v;
  const Vec2 middle = sum / static_cast<double>(vertices.size());
  return {hull.surface_at(pose, {middle.x, middle.y, 0.0}), reach};
}

}  // namespace brash::structure
