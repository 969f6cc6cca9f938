// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/hydrodynamics/wind.hpp"

#include "wetted_faces.hpp"

namespace brash::hydrodynamics {
namespace {

/// Area and first moments of plan rings.
struct PlanIntegrals {
  double area = 0.0;  ///< [m2]
  Vec2 moment{};      ///< [m3]

  /// The triangle of the origin and a side; holes, which run clockwise, count negative.
  void add(Vec2 a, Vec2 b) {
    const double triangle = 0.5 * cross(a, b);
    area += triangle;
    moment = moment + (triangle / 3.0) * (a + b);
  }
};

/// The part of a ring of the face at height `z` that lies above the water. Its sides along the waterline may run back
/// and forth; their integrals cancel.
std::vector<Vec2> part_above(const std::vector<Vec2>& ring, double z, const Waterplane& water) {
  std::vector<Vec2> above;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    const double at_a = water.height({a.x, a.y, z}), at_b = water.height({b.x, b.y, z});
    if (at_a >= 0.0) above.push_back(a);
    if ((at_a < 0.0) != (at_b < 0.0)) above.push_back(a + (at_a / (at_a - at_b)) * (b - a));
  }
  return above;
}

}  // namespace

Wrench wind_load(const Prism& prism, const Pose& pose, const Twist& twist, const Wind& wind) {
  const Waterplane water = waterplane_in_body_frame(pose);
  if (water.up.z <= 0.0) return {};
  const double z = 0.5 * prism.thickness;
  PlanIntegrals dry;
  for (const std::vector<Vec2>& ring : prism.rings) {
    const std::vector<Vec2> above = part_above(ring, z, water);
    for (std::size_t i = 0; i < above.size(); ++i) dry.add(above[i], above[(i + 1) % above.size()]);
  }
  if (!(dry.area > 0.0)) return {};
  const Vec2 centre = (1.0 / dry.area) * dry.moment;
  const Vec3 arm = rotate(pose.rotation, {centre.x, centre.y, z});
  const Vec3 against = wind.velocity - velocity_at(twist, arm);
  const Vec3 along{against.x, against.y, 0.0};
  const Vec3 force = wind.density * wind.skin_friction * dry.area * norm(along) * along;
  return {force, cross(arm, force)};
}

}  // namespace brash::hydrodynamics
