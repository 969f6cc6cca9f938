// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "brash/geometry/polygon.hpp"

namespace brash::ice {

/// The convex hull of grid points, counter-clockwise from the smallest, without points on its sides. Exact.
geometry::Ring convex_hull(std::vector<geometry::Point> points);

/// Whether the interiors of two convex counter-clockwise rings meet. Exact: rings that touch do not overlap.
///
/// Two convex polygons are apart if and only if a side of one has the other wholly on its outer side.
bool overlap(std::span<const geometry::Point> one, std::span<const geometry::Point> other);

}  // namespace brash::ice
