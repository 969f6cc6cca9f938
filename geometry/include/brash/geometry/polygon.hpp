// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "brash/geometry/area.hpp"
#include "brash/geometry/point.hpp"

namespace brash::geometry {

/// A closed loop of grid points, the last joined to the first; shape=(n_vertices,). Outlines run counter-clockwise.
using Ring = std::vector<Point>;

/// One connected region: an outline (counter-clockwise) and its holes (clockwise).
struct Polygon {
  Ring outline;
  std::vector<Ring> holes;

  friend bool operator==(const Polygon&, const Polygon&) = default;
};

/// Axis-parallel [m]; with nothing in it `lower` exceeds `upper`.
struct Extent {
  static constexpr double kFar = std::numeric_limits<double>::infinity();

  Vec2 lower{kFar, kFar};
  Vec2 upper{-kFar, -kFar};

  bool is_empty() const { return lower.x > upper.x; }
  void add(Vec2 p);
  void add(const Extent& other);
};
Extent extent(const Polygon& polygon);  ///< of its outline

/// Signed area: positive when `ring` runs counter-clockwise. Exact.
ExactArea signed_area(std::span<const Point> ring);
/// Area of the outline less its holes. Exact.
ExactArea area(const Polygon& polygon);
/// Centroid [m], sheet frame. The polygon's area must be positive.
Vec2 centroid(const Polygon& polygon);
/// True when no vertex of the counter-clockwise `ring` turns right. Exact.
bool is_convex(std::span<const Point> ring);

/// The regular polygon with `sides` vertices on the circle, the first at angle `phase` [rad], counter-clockwise.
///
/// Every vertex lies on the circle before it is rounded to the grid, so the polygon lies inside the disc:
/// the chord error is radius (1 - cos(pi/sides)), the area is short by the factor sin(2 pi/sides)/(2 pi/sides).
Ring disc(Vec2 centre, double radius, int sides, double phase = 0.0);

/// The counter-clockwise ring through `vertices` [m], either way round, rounded to the grid.
///
/// Vertices that round to their predecessor are left out, so the ring may be shorter, even fewer than three points.
Ring ring(std::span<const Vec2> vertices);

/// `polygon` cut into convex rings by diagonals only, so that their exact areas sum to its exact area.
std::vector<Ring> convex_parts(const Polygon& polygon);

/// The convex `part` moved in by `distance` [m] on every side: where collision shapes end.
/// @return the vertices [m], counter-clockwise; empty when nothing is left.
std::vector<Vec2> inset(std::span<const Point> part, double distance);

}  // namespace brash::geometry
