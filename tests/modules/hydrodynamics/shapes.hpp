// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "brash/core/prism.hpp"
#include "brash/core/vec.hpp"

namespace brash::test {

inline Prism box(double length, double breadth, double thickness) {
  const double x = 0.5 * length, y = 0.5 * breadth;
  const std::vector<Vec2> ring{{-x, -y}, {x, -y}, {x, y}, {-x, y}};
  return {{ring}, {ring}, thickness};
}

inline Quaternion turn(Vec3 axis, double angle) {
  const Vec3 unit = normalized(axis);
  const double s = std::sin(0.5 * angle);
  return {std::cos(0.5 * angle), s * unit.x, s * unit.y, s * unit.z};
}

/// A plate with a notch and a hole, its centre of area in the origin. Area 13 = 4 x 4 - 2 x 1 (notch) - 1 x 1 (hole).
inline Prism notched_plate(double thickness) {
  // Plate [0,4]x[-2,2], notch [2,4]x[-0.5,0.5], hole [0.25,1.25]x[-0.5,0.5].
  const double shift = (16.0 * 2.0 - 2.0 * 3.0 - 1.0 * 0.75) / 13.0;
  std::vector<Vec2> outline{{0, -2}, {4, -2}, {4, -0.5}, {2, -0.5}, {2, 0.5}, {4, 0.5}, {4, 2}, {0, 2}};
  std::vector<Vec2> hole{{0.25, -0.5}, {0.25, 0.5}, {1.25, 0.5}, {1.25, -0.5}};
  std::vector<std::vector<Vec2>> parts{{{0, -2}, {4, -2}, {4, -0.5}, {0, -0.5}},
                                       {{0, 0.5}, {4, 0.5}, {4, 2}, {0, 2}},
                                       {{0, -0.5}, {0.25, -0.5}, {0.25, 0.5}, {0, 0.5}},
                                       {{1.25, -0.5}, {2, -0.5}, {2, 0.5}, {1.25, 0.5}}};
  const auto centre = [shift](std::vector<Vec2>& ring) {
    for (Vec2& vertex : ring) vertex.x -= shift;
  };
  centre(outline);
  centre(hole);
  for (auto& part : parts) centre(part);
  return {{outline, hole}, parts, thickness};
}

}  // namespace brash::test
