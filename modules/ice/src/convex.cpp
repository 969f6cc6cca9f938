// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "random_placement.hpp"

namespace brash::ice {
namespace {

using geometry::Int128;
using geometry::Point;

/// Twice the area of a triangle, positive when `c` lies left of a -> b: coordinates have 43 bits, so it has 91.
Int128 turn(Point a, Point b, Point c) {
  return static_cast<Int128>(b.x - a.x) * (c.y - a.y) - static_cast<Int128>(b.y - a.y) * (c.x - a.x);
}

bool a_side_separates(std::span<const Point> ring, std::span<const Point> other) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point from = ring[i], to = ring[(i + 1) % ring.size()];
    if (std::ranges::all_of(other, [&](Point p) { return turn(from, to, p) <= 0; })) return true;
  }
  return false;
}

}  // namespace

/// Monotone chains (Andrew 1979).
geometry::Ring convex_hull(std::vector<Point> points) {
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  geometry::Ring hull;
  const auto chain = [&](auto begin, auto end, std::size_t least) {
    for (auto p = begin; p != end; ++p) {
      while (hull.size() > least && turn(hull[hull.size() - 2], hull.back(), *p) <= 0) hull.pop_back();
      hull.push_back(*p);
    }
  };
  chain(points.begin(), points.end(), 1);
  chain(points.rbegin() + 1, points.rend(), hull.size());
  hull.pop_back();
  return hull;
}

bool overlap(std::span<const Point> one, std::span<const Point> other) {
  return !a_side_separates(one, other) && !a_side_separates(other, one);
}

}  // namespace brash::ice
