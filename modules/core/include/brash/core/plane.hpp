// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "brash/core/vec.hpp"

namespace brash {

/// Half-space dot(normal, x) <= offset, `normal` a unit vector out of the solid.
struct Plane {
  Vec3 normal{};
  double offset = 0.0;
};

/// A convex solid as the half-spaces that it is common to.
using Solid = std::span<const Plane>;

/// How far `point` is out of the solid by its farthest plane [m]: minus the depth inside, outside at most the distance.
inline double signed_distance(Solid solid, Vec3 point) {
  double farthest = -std::numeric_limits<double>::infinity();
  for (const Plane& plane : solid) farthest = std::max(farthest, dot(plane.normal, point) - plane.offset);
  return farthest;
}

}  // namespace brash
