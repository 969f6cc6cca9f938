// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/core/vec.hpp"
#include "brash/model/checkpoint.hpp"
#include "brash/rigid_body/world.hpp"

namespace brash::simulation {

/// Adds a contact of a floe with the sheet.
void add_contact(model::Bearing& bearing, const rigid_body::ContactLoad& contact);

/// Moves `mean` by `share` of its distance to `now`.
void approach(model::Bearing& mean, const model::Bearing& now, double share);

/// A bearing as an even load on a straight piece of edge.
struct LineLoad {
  Vec2 middle{};
  Vec2 towards{};             ///< unit vector along the thrust, into the ice
  double length = 0.0;        ///< across it [m]
  double normal = 0.0;        ///< N along `towards` [N]
  double across = 0.0;        ///< f counter-clockwise from it [N]
  double out_of_plane = 0.0;  ///< |P| [N]
};

/// @param bearing  with some weight.
LineLoad line_load(const model::Bearing& bearing);

}  // namespace brash::simulation
