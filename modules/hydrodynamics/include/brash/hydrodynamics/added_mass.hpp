// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/core/prism.hpp"
#include "brash/core/vec.hpp"

namespace brash::hydrodynamics {

/// Added mass of a floe by direction, body frame, with both faces wet.
struct AddedMass {
  double along = 0.0;   ///< along the plate's plane [kg]
  double across = 0.0;  ///< along its normal [kg], >= `along`
  Vec3 inertia{};       ///< about the body's axes [kg m2]
};

/// Added mass of a thin plate deep in water at rest, without walls (docs/theory/water.md, (H16), (H17), (H18)).
///
/// A rectangle with the plan's area and the ratio of its principal second moments represents the plan. It errs by 2 %
/// for trapezoids, by 5 % for a disc and by 9 % for an equilateral triangle.
///
/// @param density  of the water [kg/m3], > 0.
/// @see C. E. Brennen, A Review of Added Mass and Fluid Inertial Forces, 1982; J. N. Newman, Marine Hydrodynamics,
/// 1977.
AddedMass added_mass_of_plate(const Prism& prism, double density);

/// Share of the added mass that a floe in `pose` has [-], (H19): half for each face, as far as it is wet.
/// @param flooded  share of the upper face below the waterplane that water has reached [-].
double wetted_share(const Prism& prism, const Pose& pose, double flooded = 1.0);

/// Water that moves with a body, over the water's density.
struct EntrainedWater {
  Vec3 along{};  ///< for velocities along x, y and z [m3]
  Vec3 about{};  ///< for turns about x, y and z [m5]
};

/// Water that moves with the lower half of an ellipsoid whose upper half is out of the water: half of the water that
/// moves with the whole ellipsoid in deep water.
///
/// That is exact for slow surge, sway and yaw, where the surface stays flat, and for fast heave, roll and pitch, where
/// the pressure at the surface stays constant. Waves lie between.
///
/// @param semi_axes  along x, y and downwards [m], > 0.
/// @see H. Lamb, Hydrodynamics, 6th ed., 1932, art. 114 and 115; docs/theory/structures.md, (B8).
EntrainedWater entrained_by_half(Vec3 semi_axes);

}  // namespace brash::hydrodynamics
