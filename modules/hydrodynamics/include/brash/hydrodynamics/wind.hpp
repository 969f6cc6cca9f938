// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/core/prism.hpp"
#include "brash/core/vec.hpp"

namespace brash::hydrodynamics {

/// The wind over the ice.
struct Wind {
  Vec3 velocity{};             ///< horizontal [m/s]
  double density = 0.0;        ///< of the air [kg/m3]
  double skin_friction = 0.0;  ///< C_a of (F8), without a factor of one half [-]
};

/// Load of the wind on the part of a floe's upper face that lies above the waterplane [N], [N m]; world axes, moment
/// about the centre of mass. None where the upper face looks down.
///
/// The face is dragged along the horizontal wind against it, at the velocity of the dry part's centroid.
/// @see docs/theory/ice.md, (F8)
Wrench wind_load(const Prism& prism, const Pose& pose, const Twist& twist, const Wind& wind);

}  // namespace brash::hydrodynamics
