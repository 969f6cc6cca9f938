// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/geometry/polygon.hpp"
#include "brash/model/case.hpp"
#include "brash/rigid_body/world.hpp"

namespace brash::simulation {

/// Height of walls and shores above and below the water [m]: floes that pile up stay within it.
double border_height(const model::Case& resolved);

/// Lays the walls of a field of floes and the shore of any field into `world`: ice to the floes and sheets that meet
/// them, and nothing to the structure.
/// @return the box around each.
/// @throws InputError when the file of the shore cannot be read.
std::vector<geometry::Extent> lay_borders(const model::Case& resolved, rigid_body::World& world);

}  // namespace brash::simulation
