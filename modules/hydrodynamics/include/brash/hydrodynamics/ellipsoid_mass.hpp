// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/core/vec.hpp"

namespace brash::hydrodynamics {

/// Water that moves with a body, over the water's density.
struct EntrainedWater {
  Vec3 along{};  ///< for velocities along x, y and z [m3]
  Vec3 about{};  ///< for turns about x, y and z [m5]
};

/// Water that moves with the lower half of an ellipsoid whose upper half is out of the water: half of the water that
/// moves with the whole ellipsoid in deep water.
///
/// That is exact for slow surge, sway and yaw, where the surface stays flat, and for fast heave, roll and pitch, where
/// the pressure at the surface stays constant. Waves lie between.
///
/// @param semi_axes  along x, y and downwards [m], > 0.
/// @see H. Lamb, Hydrodynamics, 6th ed., 1932, art. 114 and 115; docs/theory/structures.md, (B8).
EntrainedWater entrained_by_half(Vec3 semi_axes);

}  // namespace brash::hydrodynamics
