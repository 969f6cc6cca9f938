// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/structure/floating_body.hpp"

#include <cmath>

#include "brash/core/error.hpp"
#include "brash/hydrodynamics/ellipsoid_mass.hpp"
#include "frustum.hpp"

namespace brash::structure {
namespace {

Vec3 times(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

/// Squares of the arms from the middle of the legs, along x and y, summed over the legs [m2].
Vec2 squared_arms(const std::vector<Vec2>& places) {
  Vec2 middle{}, squares{};
  for (const Vec2 place : places) middle += place / static_cast<double>(places.size());
  for (const Vec2 place : places) {
    const Vec2 arm = place - middle;
    squares += {arm.x * arm.x, arm.y * arm.y};
  }
  return squares;
}

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
  const HullCopies copies = hull.copies();
  const HalfEllipsoid half = fitted_ellipsoid(*copies.hull);
  const Vec3 squares = times(half.semi_axes, half.semi_axes);
  // Uniform ellipsoids about the middle of their centres.
  const auto n = static_cast<double>(copies.places.size());
  const Vec2 arms = squared_arms(copies.places);
  const Vec3 own =
      diagonal_in_hull(0.2 * Vec3{squares.y + squares.z, squares.z + squares.x, squares.x + squares.y}, half.heading);
  const Vec3 radii_squared = own + Vec3{arms.y, arms.x, arms.x + arms.y} / n;
  const hydrodynamics::EntrainedWater water = hydrodynamics::entrained_by_half(half.semi_axes);
  const Vec3 along = diagonal_in_hull(water.along, half.heading), about = diagonal_in_hull(water.about, half.heading);

  Inertia inertia{.mass = body.mass.value_or(density * wet.volume),
                  .centre = body.centre_of_gravity.value_or(Vec3{wet.centre.x, wet.centre.y, 0.0})};
  inertia.moments =
      inertia.mass * (body.radii_of_gyration ? times(*body.radii_of_gyration, *body.radii_of_gyration) : radii_squared);
  inertia.added_mass = body.added_mass.value_or(density * n * along);
  inertia.added_inertia = body.added_inertia.value_or(
      density * (n * about + Vec3{along.z * arms.y, along.z * arms.x, along.x * arms.y + along.y * arms.x}));
  return inertia;
}

}  // namespace brash::structure
