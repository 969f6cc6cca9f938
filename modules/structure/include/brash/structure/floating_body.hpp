// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/model/structure.hpp"
#include "brash/structure/hull.hpp"

namespace brash::structure {

/// The inertia of a hull that floats, about its centre of gravity and along the hull's axes.
struct Inertia {
  double mass = 0.0;     ///< [kg]
  Vec3 centre{};         ///< of gravity, hull's frame [m]
  Vec3 moments{};        ///< principal moments [kg m2]
  Vec3 added_mass{};     ///< [kg]
  Vec3 added_inertia{};  ///< [kg m2]
};

/// The inertia of `body`, with defaults where it states none: the mass of the water that the hull displaces as it lies;
/// its centre on the waterplane above the centre of buoyancy; the radii of gyration and the added mass of the fitted
/// half ellipsoid. Legs and outlines of the waterline have one each, as if alone, and add up.
/// @param density  of the water [kg/m3].
/// @throws InputError when the hull displaces no water.
/// @see docs/theory/structures.md, (B7) and (B8)
Inertia inertia_of(const model::FloatingBody& body, const Hull& hull, double density);

/// The displacement of the hull's mesh. A round cone is its facets here, upright too: buoyancy then changes steadily
/// with the pose.
Displacement displaced_by_mesh(const Hull& hull, const Pose& pose);

/// A half ellipsoid for each outline of a hull's waterline, as fitted_ellipsoid() makes one for them all: several
/// columns of one mesh. They share the displaced volume by their areas, so all are equally deep.
std::vector<HalfEllipsoid> fitted_ellipsoids(const Hull& hull);

}  // namespace brash::structure
