// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "brash/core/vec.hpp"
#include "brash/hydrodynamics/water.hpp"
#include "brash/rigid_body/world.hpp"

namespace brash::floes {

/// The drag on a floe, kept until the floe has moved on (docs/theory/water.md, (H13), (H14)).
struct KeptDrag {
  hydrodynamics::Drag drag;
  Twist velocity{};   ///< against the water at which it was taken, body frame
  double left = 0.0;  ///< how far the floe may still move with it [m]; at 0 the drag is recomputed in the next step

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    auto& [form, skin, skin_power] = self.drag;
    visit("drag_left", "m", "distance until its drag is computed again", self.left);
    visit("drag_sum", "kg s-1", "sum of its dampers", form.sum);
    visit("drag_first_", "kg m s-1", "their first moment", form.first);
    visit("drag_squares_", "kg m2 s-1", "their second moments xx, yy, zz", form.squares);
    visit("drag_products_", "kg m2 s-1", "their second moments yz, zx, xy", form.products);
    visit("drag_rotation", "kg m2 s-1", "damper of its rotation", form.rotation);
    visit("drag_normal_squares_", "kg s-1", "its dampers along normals, moments xx, yy, zz of the normals",
          form.normal.squares);
    visit("drag_normal_products_", "kg s-1", "their moments yz, zx, xy of the normals", form.normal.products);
    visit("drag_with_x_", "kg m s-1", "their moments of normal x and arm", form.normal.with_x);
    visit("drag_with_y_", "kg m s-1", "their moments of normal y and arm", form.normal.with_y);
    visit("drag_with_z_", "kg m s-1", "their moments of normal z and arm", form.normal.with_z);
    visit("drag_turning_squares_", "kg m2 s-1", "their moments xx, yy, zz of the arms", form.normal.turning_squares);
    visit("drag_turning_products_", "kg m2 s-1", "their moments yz, zx, xy of the arms", form.normal.turning_products);
    visit("drag_skin_force_", "N", "skin friction, body frame", skin.force);
    visit("drag_skin_moment_", "N m", "its moment", skin.moment);
    visit("drag_skin_power", "W", "its power", skin_power);
    visit("drag_linear_", "m s-1", "velocity against the water at which its drag was computed, body frame",
          self.velocity.linear);
    visit("drag_angular_", "rad s-1", "angular velocity at which its drag was computed, body frame",
          self.velocity.angular);
  }

  /// A step of `dt` [s] in which the floe moves at `now` against the water, body frame.
  /// @return the drag at that velocity; nothing when it is to be recomputed.
  std::optional<hydrodynamics::Drag> follow(const rigid_body::MassProperties& mass, const Twist& now, double dt);
};

}  // namespace brash::floes
