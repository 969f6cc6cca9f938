// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "brash/core/constants.hpp"
#include "brash/rigid_body/world.hpp"

namespace brash::rigid_body::testing {

inline constexpr double kDensity = 900.0;

inline std::vector<Vec2> rectangle(Vec2 lower, Vec2 upper) {
  return {lower, {upper.x, lower.y}, upper, {lower.x, upper.y}};
}

/// A floe of one convex plan ring at its place in the sheet, its mid-plane at z = 0.
inline BodyId add_floe(World& world, const std::vector<Vec2>& ring, double thickness, const Twist& twist = {},
                       double added_mass = 0.0) {
  const std::vector<std::vector<Vec2>> rings{ring};
  const PlacedPrism placed = place_prism(rings, rings, thickness, 0.0);
  return world.add_floe(placed.prism, mass_properties(placed.prism, kDensity, added_mass), placed.pose, twist);
}

inline std::vector<Vec3> box(Vec3 lower, Vec3 upper) {
  std::vector<Vec3> corners;
  for (const double x : {lower.x, upper.x})
    for (const double y : {lower.y, upper.y})
      for (const double z : {lower.z, upper.z}) corners.push_back({x, y, z});
  return corners;
}

/// Frustum of a downward-breaking cone: radius `r` at z = 0, its side at `angle` from the horizontal, narrower below.
inline std::vector<Vec3> cone(double r, double angle, double below, double above, int facets = 64) {
  std::vector<Vec3> corners;
  for (const double z : {-below, above})
    for (int i = 0; i < facets; ++i) {
      const double t = 2.0 * kPi * i / facets;
      const double radius = r + z / std::tan(angle);
      corners.push_back({radius * std::cos(t), radius * std::sin(t), z});
    }
  return corners;
}

inline BodyId add_structure(World& world, const std::vector<Vec3>& hull, const Pose& pose = {}) {
  const std::vector<std::vector<Vec3>> hulls{hull};
  return world.add_structure(hulls, pose);
}

/// Moves the structure on at constant velocity for the next step.
inline void push(World& world, BodyId structure, Vec3 velocity, double dt) {
  Pose pose = world.pose(structure);
  pose.position += dt * velocity;
  world.move_structure(structure, pose, {velocity, {}});
}

inline double total_normal_force(const World& world) {
  double sum = 0.0;
  for (const ContactLoad& c : world.contacts()) sum += c.normal_force;
  return sum;
}

}  // namespace brash::rigid_body::testing
