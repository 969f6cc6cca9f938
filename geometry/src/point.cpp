// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/geometry/point.hpp"

#include <cmath>

#include "brash/core/contract.hpp"

namespace brash::geometry {

Point snap(Vec2 metres) {
  // A NaN fails both comparisons. Scaling by a power of two is exact, so the only rounding is llround's.
  BRASH_EXPECTS(std::abs(metres.x) <= kMaxCoordinate && std::abs(metres.y) <= kMaxCoordinate, metres.x, metres.y);
  return Point::of_units(std::llround(metres.x / kGridUnit), std::llround(metres.y / kGridUnit));
}

}  // namespace brash::geometry
