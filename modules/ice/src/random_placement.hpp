// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "brash/geometry/polygon.hpp"
#include "brash/statistics/random.hpp"

namespace brash::ice {

/// The convex hull of grid points, counter-clockwise from the smallest, without points on its sides. Exact.
geometry::Ring convex_hull(std::vector<geometry::Point> points);

/// Whether the interiors of two convex counter-clockwise rings meet. Exact: rings that touch do not overlap.
///
/// Two convex polygons are apart if and only if a side of one has the other wholly on its outer side.
bool overlap(std::span<const geometry::Point> one, std::span<const geometry::Point> other);

/// A rectangle, x from 0 to `length`, |y| <= width/2 [m].
struct Domain {
  double length = 0.0;
  double width = 0.0;

  double area() const { return length * width; }
};

/// Convex rings in a rectangle, found by place: a square grid has the numbers of those whose boxes meet each cell.
class PlacedRings {
 public:
  /// @param side  of a cell: about the distance of two rings [m].
  PlacedRings(const Domain& domain, double side);

  /// Whether the interior of `ring` meets another's. Exact.
  bool meets(std::span<const geometry::Point> ring) const;
  void add(geometry::Ring ring);

  std::size_t size() const { return rings_.size(); }
  const std::vector<geometry::Ring>& rings() const { return rings_; }

 private:
  struct Cells {
    int left = 0, right = 0, low = 0, high = 0;
  };
  Cells cells_of(const geometry::Extent& box) const;
  const std::vector<std::size_t>& cell(int i, int j) const;

  double side_, low_;
  int n_columns_, n_rows_;
  std::vector<geometry::Ring> rings_;
  std::vector<geometry::Extent> boxes_;
  std::vector<std::vector<std::size_t>> cells_;
};

/// Places regular polygons of the given areas in `domain`, the largest first, each at the first random place and angle
/// where it meets no other (random sequential addition; docs/theory/ice.md, (F6)).
///
/// @param areas     [m2].
/// @param sides     4 for squares.
/// @param keep_out  convex rings that none may meet.
/// @return the rings in the order of `areas`; none when a ring found no place.
std::vector<geometry::Ring> place_at_random(const Domain& domain, std::span<const double> areas, int sides,
                                            std::span<const geometry::Ring> keep_out, statistics::RandomStream& random);

}  // namespace brash::ice
