// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/structure/floating_body.hpp"

#include <cmath>
#include <vector>

#include "brash/core/error.hpp"
#include "brash/hydrodynamics/added_mass.hpp"
#include "frustum.hpp"

namespace brash::structure {
namespace {

Vec3 times(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

/// The diagonal of a tensor in the hull's axes, from its diagonal in axes that head by `heading` in them.
Vec3 diagonal_in_hull(Vec3 own, double heading) {
  const double c = std::cos(heading) * std::cos(heading), s = 1.0 - c;
  return {c * own.x + s * own.y, s * own.x + c * own.y, own.z};
}

/// Bodies side by side as one, about the middle of their places.
struct Gathered {
  Vec3 radii_squared{};  ///< of gyration [m2]
  Vec3 along{};          ///< entrained water over its density [m3]
  Vec3 about{};          ///< [m5]
};

/// Squares of the arms from the middle of `places`, along x and y, with `shares` that add up to one [m2].
Vec2 squared_arms(const std::vector<Vec2>& places, const std::vector<double>& shares, std::size_t i) {
  Vec2 middle{};
  for (std::size_t j = 0; j < places.size(); ++j) middle += shares[j] * places[j];
  const Vec2 arm = places[i] - middle;
  return {arm.x * arm.x, arm.y * arm.y};
}

/// By parallel axes.
Gathered gathered(const std::vector<Gathered>& bodies, const std::vector<Vec2>& places,
                  const std::vector<double>& shares) {
  Gathered sum;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Gathered& body = bodies[i];
    const Vec2 arms = squared_arms(places, shares, i);
    sum.radii_squared += shares[i] * (body.radii_squared + Vec3{arms.y, arms.x, arms.x + arms.y});
    sum.along += body.along;
    sum.about +=
        body.about + Vec3{body.along.z * arms.y, body.along.z * arms.x, body.along.x * arms.y + body.along.y * arms.x};
  }
  return sum;
}

/// The uniform half ellipsoids of one hull.
Gathered ellipsoids_of(const Hull& hull) {
  std::vector<Gathered> bodies;
  std::vector<Vec2> places;
  std::vector<double> shares;
  double area = 0.0;
  for (const HalfEllipsoid& half : fitted_ellipsoids(hull)) {
    const Vec3 squares = times(half.semi_axes, half.semi_axes);
    const hydrodynamics::EntrainedWater water = hydrodynamics::entrained_by_half(half.semi_axes);
    bodies.push_back({diagonal_in_hull(0.2 * Vec3{squares.y + squares.z, squares.z + squares.x, squares.x + squares.y},
                                       half.heading),
                      diagonal_in_hull(water.along, half.heading), diagonal_in_hull(water.about, half.heading)});
    places.push_back(half.centre);
    shares.push_back(half.semi_axes.x * half.semi_axes.y);
    area += shares.back();
  }
  for (double& share : shares) share /= area;
  return gathered(bodies, places, shares);
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
  const std::size_t n = copies.places.size();
  const Gathered all = gathered(std::vector<Gathered>(n, ellipsoids_of(*copies.hull)), copies.places,
                                std::vector<double>(n, 1.0 / static_cast<double>(n)));

  Inertia inertia{.mass = body.mass.value_or(density * wet.volume),
                  .centre = body.centre_of_gravity.value_or(Vec3{wet.centre.x, wet.centre.y, 0.0})};
  inertia.moments = inertia.mass * (body.radii_of_gyration ? times(*body.radii_of_gyration, *body.radii_of_gyration)
                                                           : all.radii_squared);
  inertia.added_mass = body.added_mass.value_or(density * all.along);
  inertia.added_inertia = body.added_inertia.value_or(density * all.about);
  return inertia;
}

}  // namespace brash::structure
