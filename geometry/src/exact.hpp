// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "brash/geometry/area.hpp"
#include "brash/geometry/point.hpp"
#include "predicates.hpp"

// Predicates and the one construction of the noding, on whole numbers. Coordinates have 44 bits, so a cross product of
// differences has at most 91: 128 bits hold it and no filter is needed. Signs of three points are CGAL's (side).
namespace brash::geometry::exact {

/// a x b about the origin: the share of a directed edge in twice the area of its loop.
inline Int128 cross(Point a, Point b) { return static_cast<Int128>(a.x) * b.y - static_cast<Int128>(a.y) * b.x; }

/// (b - a) . (c - a)
inline Int128 dot(Point a, Point b, Point c) {
  return static_cast<Int128>(b.x - a.x) * (c.x - a.x) + static_cast<Int128>(b.y - a.y) * (c.y - a.y);
}

/// Closed box of grid points.
struct Box {
  Point low;
  Point high;

  static Box of(Point a, Point b) {
    return {Point::of_units(std::min(a.x, b.x), std::min(a.y, b.y)),
            Point::of_units(std::max(a.x, b.x), std::max(a.y, b.y))};
  }
  void add(Point p) {
    low = Point::of_units(std::min(low.x, p.x), std::min(low.y, p.y));
    high = Point::of_units(std::max(high.x, p.x), std::max(high.y, p.y));
  }
  Box grown(std::int64_t by) const { return {low - Point::of_units(by, by), high + Point::of_units(by, by)}; }
  bool contains(Point p) const { return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y; }
  bool overlaps(const Box& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y;
  }
};

/// The box of a non-empty ring.
inline Box box_of(std::span<const Point> ring) {
  Box box{ring.front(), ring.front()};
  for (const Point p : ring) box.add(p);
  return box;
}

/// True when the segment a b meets the half-open pixel [p - 1/2, p + 1/2) x [p - 1/2, p + 1/2).
///
/// a and b are grid points, never on a pixel's side, so the segment reaches the pixel's rows and columns exactly when
/// p is in its box. The line then meets the open pixel when 2|f| < |dx| + |dy|, f = turn(a, b, p); with equality it
/// touches one corner, and only the lower left one belongs to the pixel; docs/theory/geometry.md, (1).
inline bool meets_pixel(Point a, Point b, Point p) {
  if (!Box::of(a, b).contains(p)) return false;
  const std::int64_t dx = b.x - a.x;
  const std::int64_t dy = b.y - a.y;
  const Int128 twice = 2 * turn(a, b, p);
  const Int128 distance = twice < 0 ? -twice : twice;
  const Int128 reach = static_cast<Int128>(dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy);
  return distance < reach || (distance == reach && twice == static_cast<Int128>(dx) - dy);
}

/// True when the open segments a b and c d cross in one point.
inline bool cross_properly(Point a, Point b, Point c, Point d) {
  if (a == c || a == d || b == c || b == d)
    return false;  // Decided without signs that are exactly zero, which are slow.
  const int c_side = side(a, b, c);
  const int d_side = side(a, b, d);
  if (c_side * d_side >= 0) return false;
  return side(c, d, a) * side(c, d, b) < 0;
}

/// floor(length * numerator / denominator + 1/2) for 0 <= numerator <= denominator, exact.
std::int64_t scaled(std::int64_t length, Int128 numerator, Int128 denominator);

/// The grid point in whose half-open pixel the crossing of a b and c d lies; they must cross properly.
Point rounded_crossing(Point a, Point b, Point c, Point d);

/// How often the closed `ring` winds around `p`, which is not on it; `scale`: p represents p / scale.
int winding(std::span<const Point> ring, Point p, int scale = 1);

/// True when the ray from p in +x direction, raised by less than any vertex, meets the segment; not when p is on it.
inline bool meets_ray(Point from, Point to, Point p) {
  const bool up = from.y < to.y;
  const Point low = up ? from : to;
  const Point high = up ? to : from;
  return low.y <= p.y && p.y < high.y && side(low, high, p) > 0;
}

/// True when segment a meets such a ray before segment b does; both meet it and they do not cross.
bool is_met_before(Point a_from, Point a_to, Point b_from, Point b_to);

}  // namespace brash::geometry::exact
