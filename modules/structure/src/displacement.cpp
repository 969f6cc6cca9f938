// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "brash/core/constants.hpp"
#include "frustum.hpp"

namespace brash::structure {
namespace {

/// The corners of a triangle's part below z = 0.
struct Wet {
  std::array<Vec3, 4> corners{};
  std::size_t n = 0;

  void push_back(Vec3 corner) { corners[n++] = corner; }
};

Wet below_water(const std::array<Vec3, 3>& triangle) {
  Wet kept;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 a = triangle[i], b = triangle[(i + 1) % 3];
    if (a.z <= 0.0) kept.push_back(a);
    if ((a.z <= 0.0) == (b.z <= 0.0)) continue;
    const Vec3 crossing = a + a.z / (a.z - b.z) * (b - a);
    kept.push_back({crossing.x, crossing.y, 0.0});
  }
  return kept;
}

}  // namespace

/// Sums over tetrahedra from a point of the water's surface, so that the waterplane adds nothing. The plan areas of a
/// closed surface add up to none, so the plan areas of its wet part are the waterplane's with the sign changed.
Displacement displacement_of(const TriangleMesh& mesh, const std::vector<Vec3>& world) {
  const Vec3 apex{world.front().x, world.front().y, 0.0};
  double volume = 0.0, area = 0.0;
  Vec3 moment{};
  Vec2 area_moment{};
  for (const auto& [i, j, k] : mesh.triangles) {
    const auto at = [&](int vertex) { return world[static_cast<std::size_t>(vertex)] - apex; };
    const auto [wet, n] = below_water({at(i), at(j), at(k)});
    for (std::size_t c = 2; c < n; ++c) {
      const Vec3 a = wet[0], b = wet[c - 1], d = wet[c];
      const double tetrahedron = dot(a, cross(b, d)) / 6.0;
      volume += tetrahedron;
      moment += tetrahedron / 4.0 * (a + b + d);
      const double in_plan = 0.5 * cross(plan(b - a), plan(d - a));
      area -= in_plan;
      area_moment += -in_plan / 3.0 * plan(a + b + d);
    }
  }
  if (!(volume > 0.0)) return {};
  const Vec2 middle = area > 0.0 ? area_moment / area : Vec2{};
  return {volume,
          apex + moment / volume,
          {.area = area, .radius = std::sqrt(std::max(area, 0.0) / kPi), .centre = plan(apex) + middle}};
}

}  // namespace brash::structure
