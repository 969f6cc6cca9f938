// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>

#include "brash/core/vec.hpp"

namespace brash::geometry {

/// Side of the dyadic grid on which every stored vertex lies [m]: 2^-30 m, about 1 nm. Doubles hold it exactly.
inline constexpr double kGridUnit = 1.0 / (1LL << 30);
/// Largest coordinate that the exact arithmetic covers [m].
inline constexpr double kMaxCoordinate = 8192.0;

/// Point of the plan on the dyadic grid, sheet frame [grid units].
///
/// snap() makes one from metres and of_units() from whole grid units. Braces make none, so metres cannot slip in.
struct Point {
  std::int64_t x = 0;
  std::int64_t y = 0;

  constexpr Point() = default;
  /// The point `x` and `y` grid units from the origin.
  static constexpr Point of_units(std::integral auto x, std::integral auto y) {
    Point point;
    point.x = static_cast<std::int64_t>(x);
    point.y = static_cast<std::int64_t>(y);
    return point;
  }

  friend constexpr Point operator+(Point a, Point b) { return of_units(a.x + b.x, a.y + b.y); }
  friend constexpr Point operator-(Point a, Point b) { return of_units(a.x - b.x, a.y - b.y); }
  friend constexpr auto operator<=>(const Point&, const Point&) = default;
};

/// The grid point nearest to `metres`, halves away from zero.
/// @throws ContractViolation when not finite or beyond kMaxCoordinate.
Point snap(Vec2 metres);

/// The place of `point` [m], exact.
constexpr Vec2 metres(Point point) {
  return {static_cast<double>(point.x) * kGridUnit, static_cast<double>(point.y) * kGridUnit};
}

}  // namespace brash::geometry
