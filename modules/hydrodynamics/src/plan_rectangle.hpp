// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "brash/core/prism.hpp"

namespace brash::hydrodynamics {

/// The rectangle that has the area of a plan and the ratio of its principal second moments; sides along the body's
/// axes.
struct PlanRectangle {
  explicit PlanRectangle(const Prism& prism) {
    double xx = 0.0, yy = 0.0;
    for (const auto& ring : prism.rings) {
      if (ring.empty()) continue;
      Vec2 a = ring.back();
      for (const Vec2 b : ring) {
        const double twice = cross(a, b);
        area += 0.5 * twice;
        xx += twice * (a.x * a.x + a.x * b.x + b.x * b.x);
        yy += twice * (a.y * a.y + a.y * b.y + b.y * b.y);
        a = b;
      }
    }
    x = std::sqrt(area * std::sqrt(xx / yy));
    y = area / x;
  }

  double area = 0.0;  ///< [m2]
  double x = 0.0;     ///< [m]
  double y = 0.0;     ///< [m]
};

}  // namespace brash::hydrodynamics
