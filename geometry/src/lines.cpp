// SPDX-License-Identifier: GPL-3.0-or-later
// Lines as cracks.
#include <algorithm>
#include <cmath>

#include "brash/geometry/text.hpp"

namespace brash::geometry {
namespace {

/// Rounding moves a line and the edge that it meets by two units of the grid, 2 nm, at most: this meets at angles above
/// 1 degree.
constexpr double kBeyond = 1e-7;  // [m]

/// `end` of the crack from `start`, moved away from there; as it is at the rim of the grid.
Point beyond(Point start, Point end) {
  const Vec2 along = metres(end) - metres(start);
  const Vec2 moved = metres(end) + (kBeyond / norm(along)) * along;
  return std::max(std::abs(moved.x), std::abs(moved.y)) <= kMaxCoordinate ? snap(moved) : end;
}

}  // namespace

std::vector<Crack> beyond_free_ends(std::vector<Crack> cracks) {
  Ring ends;
  for (const Crack& crack : cracks) ends.insert(ends.end(), {crack.from, crack.to});
  std::sort(ends.begin(), ends.end());
  const auto is_free = [&](Point end) {
    const auto [first, last] = std::equal_range(ends.begin(), ends.end(), end);
    return last - first == 1;
  };
  for (Crack& crack : cracks) {
    const Crack given = crack;
    if (given.from == given.to) continue;
    if (is_free(given.from)) crack.from = beyond(given.to, given.from);
    if (is_free(given.to)) crack.to = beyond(given.from, given.to);
  }
  return cracks;
}

}  // namespace brash::geometry
