// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "brash/core/vec.hpp"

namespace brash::rigid_body {

/// The convex hull of points that all differ, as triangles, counter-clockwise from outside: indices into `points`. The
/// signs that decide are exact, so the triangles close whatever the points are. None where the points lie in a plane.
std::vector<std::array<int, 3>> hull_triangles(std::span<const Vec3> points);

}  // namespace brash::rigid_body
