// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "brash/core/plane.hpp"
#include "brash/core/prism.hpp"
#include "brash/core/vec.hpp"
#include "brash/hydrodynamics/water.hpp"
#include "damping.hpp"

namespace brash::hydrodynamics {

/// Drag on the wetted surface, body frame.
struct SurfaceDrag {
  Damping form;          ///< of the whole velocity
  Wrench skin_friction;  ///< about the body frame's origin
};

/// Integrates Eq. 13, with the velocity of each place, and skin friction over the wetted surface.
///
/// @param relative  velocity relative to the water, body frame.
/// @param neighbours  world frame.
SurfaceDrag surface_drag(const Prism& prism, const Pose& pose, const Twist& relative, const Water& water,
                         std::span<const Solid> neighbours);

}  // namespace brash::hydrodynamics
