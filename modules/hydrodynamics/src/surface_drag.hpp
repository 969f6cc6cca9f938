// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "brash/core/plane.hpp"
#include "brash/core/prism.hpp"
#include "brash/core/vec.hpp"
#include "brash/hydrodynamics/water.hpp"

namespace brash::hydrodynamics {

/// Integrates Eq. 13, with the velocity of each place, and skin friction over the wetted surface.
///
/// @param relative  velocity relative to the water, body frame.
/// @param neighbours  world frame.
Drag surface_drag(const Prism& prism, const Pose& pose, const Twist& relative, const Water& water,
                  std::span<const Solid> neighbours);

}  // namespace brash::hydrodynamics
