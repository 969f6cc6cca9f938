// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "brash/core/vec.hpp"
#include "brash/hydrodynamics/water.hpp"
#include "brash/rigid_body/world.hpp"

namespace brash::simulation {

/// The drag on a floe, kept until the floe has moved on (docs/theory/hydrodynamics.md, (H13), (H14)).
struct KeptDrag {
  hydrodynamics::Drag drag;
  Twist velocity{};   ///< against the water at which it was taken, body frame
  double left = 0.0;  ///< how far the floe may go on with it [m]; at 0 it is taken anew in the next step

  /// A step of `dt` [s] in which the floe moves at `now` against the water, body frame.
  /// @return the drag at that velocity; nothing when it is to be taken anew.
  std::optional<hydrodynamics::Drag> follow(const rigid_body::MassProperties& mass, const Twist& now, double dt);
};

}  // namespace brash::simulation
