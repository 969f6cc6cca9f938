// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "brash/geometry/polygon.hpp"

namespace brash::geometry {

/// The mean caliper diameter of the simple `ring` [m]: the distance between two parallel tangents, averaged over all
/// directions. It is the perimeter of the convex hull over pi.
///
/// @see Cauchy 1832; Rothrock and Thorndike 1984; docs/theory/ice.md, (D1).
double mean_caliper_diameter(std::span<const Point> ring);

}  // namespace brash::geometry
