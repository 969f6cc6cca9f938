// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/core/vec.hpp"
#include "brash/structure/hull.hpp"

namespace brash::structure {

/// Convex bodies in place of a closed mesh.
struct ConvexBodies {
  std::vector<ConvexPart> parts;
  double error = 0.0;  ///< their volume beyond the mesh's and short of it, over the mesh's volume [-]
};

/// One body for each shell that is nearly convex. The others are cut by planes along their axes, each time the part
/// that sticks out most, until the parts' volume is right or there are too many parts.
ConvexBodies convex_bodies(const TriangleMesh& mesh);

/// Sorts points by their coordinates and drops repeated ones.
void keep_one_of_each(std::vector<Vec3>& points);

/// The farthest points in `n` directions that are spread evenly over the sphere, each once, by their coordinates. Where
/// several are as far, the last by its coordinates.
/// @param points  at least one.
std::vector<Vec3> extreme_points(std::vector<Vec3> points, int n);

/// The i-th of n directions on a spiral of golden angles (Fibonacci): a unit vector.
Vec3 spread_direction(int i, int n);

}  // namespace brash::structure
