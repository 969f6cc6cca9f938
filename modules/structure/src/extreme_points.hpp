// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/core/vec.hpp"

namespace brash::structure {

/// Sorts points by their coordinates and drops repeated ones.
void keep_one_of_each(std::vector<Vec3>& points);

/// The farthest points in `n` directions that are spread evenly over the sphere, each once, by their coordinates. Where
/// several are as far, the last by its coordinates.
/// @param points  at least one.
std::vector<Vec3> extreme_points(std::vector<Vec3> points, int n);

/// The i-th of n directions on a spiral of golden angles (Fibonacci): a unit vector.
Vec3 spread_direction(int i, int n);

}  // namespace brash::structure
