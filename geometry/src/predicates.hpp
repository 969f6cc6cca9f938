// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/geometry/area.hpp"
#include "brash/geometry/point.hpp"

namespace brash::geometry {

/// Twice the signed area of the triangle `a`, `b`, `c`: positive when c lies left of a -> b. Exact.
///
/// Coordinates reach 2^43 grid units (kMaxCoordinate), so differences take 45 bits and the determinant 91.
constexpr Int128 turn(Point a, Point b, Point c) {
  return static_cast<Int128>(b.x - a.x) * (c.y - a.y) - static_cast<Int128>(b.y - a.y) * (c.x - a.x);
}

/// -1, 0 or 1: `c` right of, on or left of the line a -> b. This is CGAL::orientation on doubles, exact up to 2^53.
int side(Point a, Point b, Point c);

}  // namespace brash::geometry
