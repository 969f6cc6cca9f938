// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "body.hpp"

namespace brash::rigid_body {

/// The load of a point from the impulses on `body` [N s], velocities and loss included; Body::twist is still the twist
/// at the start of the step.
///
/// @param of_body, of_other  the place of the impulse on each body [m], world; the load is reported at the first.
ContactLoad contact_load(const Body& body, const Body& other, Vec3 of_body, Vec3 of_other, Vec3 normal,
                         double normal_impulse, Vec3 friction_impulse, double dt);

}  // namespace brash::rigid_body
