// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "brash/core/plane.hpp"
#include "brash/core/prism.hpp"
#include "brash/core/vec.hpp"
#include "brash/hydrodynamics/water.hpp"
#include "lanes.hpp"

namespace brash::hydrodynamics {

/// Share of the free stream that reaches a floe's surface where probes of the length of the gap end
/// (docs/theory/water.md, (H8)).
///
/// @param probes  their ends, body frame; at least one.
/// @param pose  of the floe.
/// @param neighbours  world frame.
/// @param gap  > 0 [m].
/// @param open  result, as many as `probes`.
void open_shares(std::span<const Vectors> probes, const Pose& pose, std::span<const Solid> neighbours, double gap,
                 std::span<Lanes> open);

/// Integrates Eq. 13, with the velocity of each place, and skin friction over the wetted surface.
///
/// @param relative  velocity relative to the water, body frame.
/// @param neighbours  world frame.
Drag surface_drag(const Prism& prism, const Pose& pose, const Twist& relative, const Water& water,
                  std::span<const Solid> neighbours);

}  // namespace brash::hydrodynamics
