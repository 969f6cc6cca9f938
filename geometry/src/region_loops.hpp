// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/geometry/polygon.hpp"
#include "predicates.hpp"

namespace brash::geometry {

/// Closed loop of indices into a list of points, the region on its left.
using Loop = std::vector<int>;

/// The boundary of a region whose outline and holes may touch themselves and each other.
struct RegionLoops {
  /// Every vertex once, sorted.
  std::vector<Point> points;
  /// One closed walk for each connected piece of the boundary of each connected piece of the region's inside.
  ///
  /// A point where the region touches itself stands once for each sector of the inside there, and parts that touch in
  /// points only are separate. Outlines have a positive area, holes a negative one.
  std::vector<Loop> loops;
};

/// The boundary of `polygon`: vertices on edges are inserted there, edges that run back on each other are left out,
/// and the loops are traced afresh. Nothing moves, so the area stays exactly the same.
RegionLoops region_loops(const Polygon& polygon);

/// True when `target` lies strictly inside the sector at `at` that runs counter-clockwise from `next` to `previous`:
/// the inside of the region at a vertex of its boundary.
inline bool is_in_sector(Point previous, Point at, Point next, Point target) {
  if (side(previous, at, next) > 0) return side(at, next, target) > 0 && side(at, previous, target) < 0;
  return !(side(at, previous, target) >= 0 && side(at, next, target) <= 0);
}

}  // namespace brash::geometry
