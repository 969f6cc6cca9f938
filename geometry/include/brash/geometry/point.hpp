// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstdint>

#include "brash/core/vec.hpp"

namespace brash::geometry {

/// Side of the dyadic grid on which every stored vertex lies [m]: 2^-30 m, about 1 nm. Doubles hold it exactly.
inline constexpr double kGridUnit = 1.0 / (1LL << 30);
/// Largest coordinate that the exact arithmetic covers [m].
inline constexpr double kMaxCoordinate = 8192.0;

/// Point of the plan on the dyadic grid, sheet frame [grid units].
struct Point {
  std::int64_t x = 0;
  std::int64_t y = 0;

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
