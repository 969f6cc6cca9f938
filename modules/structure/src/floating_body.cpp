// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/structure/floating_body.hpp"

#include <cmath>

#include "brash/core/error.hpp"
#include "brash/hydrodynamics/ellipsoid_mass.hpp"
#include "frustum.hpp"

namespace brash::structure {
namespace {

Vec3 times(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

/// The diagonal of a tensor in the hull's axes, from its diagonal in axes that head by `heading` in them.
Vec3 diagonal_in_hull(Vec3 own, double heading) {
  const double c = std::cos(heading) * std::cos(heading), s = 1.0 - c;
  return {c * own.x + s * own.y, s * own.x + c * own.y, own.z};
}

}  // namespace

Displacement displaced_by_mesh(const Hull& hull, const Pose& pose) {
  std::vector<Vec3> world;
  world.reserve(hull.mesh().vertices.size());
  for (const Vec3 v : hull.mesh().vertices) world.push_back(to_world(pose, v));
  return displacement_of(hull.mesh(), world);
}

Inertia inertia_of(const model::FloatingBody& body, const Hull& hull, double density) {
  const Displacement wet = displaced_by_mesh(hull, {});
  if (!(wet.volume > 0.0))
    throw InputError(Complaint{"structure", "displaces no water, so it cannot float",
                               "a hull with its keel under water",
                               "raise structure.height_under_water, or take another structure.motion.kind"});
  const HalfEllipsoid half = fitted_ellipsoid(hull);
  const Vec3 squares = times(half.semi_axes, half.semi_axes);
  // A uniform ellipsoid about its centre.
  const Vec3 radii_squared =
      diagonal_in_hull(0.2 * Vec3{squares.y + squares.z, squares.z + squares.x, squares.x + squares.y}, half.heading);
  const hydrodynamics::EntrainedWater water = hydrodynamics::entrained_by_half(half.semi_axes);

  Inertia inertia{.mass = body.mass.value_or(density * wet.volume),
                  .centre = body.centre_of_gravity.value_or(Vec3{wet.centre.x, wet.centre.y, 0.0})};
  inertia.moments =
      inertia.mass * (body.radii_of_gyration ? times(*body.radii_of_gyration, *body.radii_of_gyration) : radii_squared);
  inertia.added_mass = body.added_mass.value_or(density * diagonal_in_hull(water.along, half.heading));
  inertia.added_inertia = body.added_inertia.value_or(density * diagonal_in_hull(water.about, half.heading));
  return inertia;
}

}  // namespace brash::structure
