// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/core/vec.hpp"

namespace brash::structure {

/// A faceted cone: the paper's structure (Table 1, Fig. 9). Frame: axis z, origin on the waterplane.
struct Cone {
  double angle = 0.0;               ///< slope from the horizontal [rad], in (0, pi/2)
  double waterline_width = 0.0;     ///< diameter at z = 0 [m]
  double height = 0.0;              ///< from keel to top [m]
  double height_under_water = 0.0;  ///< from keel to waterplane [m]
  bool downward_breaking = true;    ///< narrower below; else narrower above
  int facets = 64;                  ///< sides of the polygon that stands for a circular section
};

/// Radius of the section at height z [m].
double radius_at(const Cone& cone, double z);

/// Volume below the waterplane, of the round cone [m3].
double displaced_volume(const Cone& cone);

/// The section at height z, counter-clockwise, in the structure's frame [m]; shape=(facets,).
/// Its vertices lie on the circle of radius_at(cone, z).
std::vector<Vec2> section(const Cone& cone, double z);

/// The vertices of the convex hull, keel then top, in the structure's frame [m]; shape=(2 facets,).
std::vector<Vec3> hull(const Cone& cone);

}  // namespace brash::structure
