// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/core/vec.hpp"

namespace brash {

/// A floe's solid: a plan outline times a thickness, in the body frame.
///
/// The body frame has its origin at the centre of mass, z along the thickness, x and y along the principal axes of the
/// plan; the solid spans z in [-thickness/2, thickness/2].
struct Prism {
  /// Closed rings of the plan [m]: the outline counter-clockwise, then the holes clockwise. The ice is on their left.
  std::vector<std::vector<Vec2>> rings;
  /// Convex rings, counter-clockwise [m], that tile the plan.
  std::vector<std::vector<Vec2>> parts;
  /// [m]
  double thickness = 0.0;
};

}  // namespace brash
