// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "floe_population.hpp"

namespace brash::simulation {

/// Gives a floe the added mass of its wet part, by hydrodynamics.added_mass_law, and books the kinetic energy that this
/// takes in Floe::shed. Added mass that leaves keeps its velocity. Added mass that comes moves with the water and takes
/// its share of the momentum, as in an impact on water (docs/theory/water.md, (H19)).
///
/// @param stream  velocity of the water there [m/s].
void take_added_mass(rigid_body::World& world, BodyId body, Floe& floe, const model::Case& resolved, Vec3 stream);

}  // namespace brash::simulation
