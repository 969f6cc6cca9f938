// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/rigid_body/world.hpp"

namespace brash::rigid_body {

/// The end of a step of a body with MassProperties::added_across.
struct Turn {
  Pose pose;
  Twist twist;
};

/// Moves a body on for `dt` [s] without forces, by Kirchhoff's equations (docs/theory/contacts-and-bodies.md, (M3)).
///
/// The momentum against the water stays as it is, although the body's axes turn. The velocity therefore changes, and
/// Munk's moment takes the energy for it from the rotation. Momentum and energy against the water are kept to
/// round-off.
///
/// @param twist  after the forces and contacts of the step.
/// @param stream  velocity of the water [m/s].
/// @see H. Lamb, Hydrodynamics, 6th ed., 1932, art. 124.
Turn turned_with_water(const MassProperties& mass, const Pose& pose, const Twist& twist, Vec3 stream, double dt);

}  // namespace brash::rigid_body
