// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "brash/core/vec.hpp"
#include "brash/rigid_body/world.hpp"

namespace brash::floes {

/// The load of a floe on the sheet: sums over its contacts there, averaged over its collision time. All moments are of
/// the sizes of the normal forces.
struct Bearing {
  Vec3 force{};                    ///< on the sheet, friction included [N]
  Vec2 thrust{};                   ///< in-plane part of its normal forces [N]
  double weight = 0.0;             ///< sum of the sizes of the normal forces [N]
  Vec3 first{};                    ///< first moments about the origin [N m]
  std::array<double, 3> second{};  ///< second moments xx, xy, yy about the origin [N m2]

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("bearing_force_", "N", "mean force on the sheet", self.force);
    visit("bearing_thrust_", "N", "mean normal force on the sheet in plan", self.thrust);
    visit("bearing_weight", "N", "sum of their sizes", self.weight);
    visit("bearing_first_", "N m", "their first moment", self.first);
    visit("bearing_second_xx", "N m2", "their second moment", self.second[0]);
    visit("bearing_second_xy", "N m2", "their second moment", self.second[1]);
    visit("bearing_second_yy", "N m2", "their second moment", self.second[2]);
  }

  friend bool operator==(const Bearing&, const Bearing&) = default;
};

/// Adds a contact of a floe with the sheet.
void add_contact(Bearing& bearing, const rigid_body::ContactLoad& contact);

/// Moves `mean` by `share` of its distance to `now`.
void approach(Bearing& mean, const Bearing& now, double share);

/// A bearing as an even load on a straight line.
struct LineLoad {
  Vec3 middle{};
  Vec2 towards{};             ///< unit vector across the line, into the ice
  double length = 0.0;        ///< [m]
  double normal = 0.0;        ///< N along `towards` [N]
  double across = 0.0;        ///< f counter-clockwise from it [N]
  double out_of_plane = 0.0;  ///< |P| [N]
};

/// @param bearing  with some weight.
/// @param towards  unit vector.
LineLoad line_load(const Bearing& bearing, Vec2 towards);

}  // namespace brash::floes
