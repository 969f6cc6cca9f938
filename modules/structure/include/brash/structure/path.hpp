// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "brash/core/vec.hpp"
#include "brash/model/structure.hpp"

namespace brash::structure {

/// A path in plan with a heading, smooth to its first derivative in time: cubic Hermite polynomials of place and
/// heading between rows, with the slopes of Akima. A part of three or more rows on a straight line at one speed stays
/// straight, but for the row next to another straight part. The heading takes the shorter way from row to row.
/// @see H. Akima, J. ACM 17, 1970; docs/theory/structures.md, (B1).
class Path {
 public:
  /// @param rows  two or more, times ascending.
  explicit Path(const std::vector<model::Waypoint>& rows);

  /// The pose at a time; before the first row and after the last one it stays there.
  Pose at(double time) const;

 private:
  using Values = std::array<double, 3>;  ///< x, y [m] and heading [rad]

  std::vector<double> times_;
  std::vector<Values> values_, slopes_;
};

}  // namespace brash::structure
