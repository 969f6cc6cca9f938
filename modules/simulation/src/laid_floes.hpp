// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/core/vec.hpp"
#include "brash/geometry/polygon.hpp"
#include "brash/ice/field.hpp"
#include "brash/model/case.hpp"
#include "brash/rigid_body/world.hpp"
#include "brash/structure/hull.hpp"

namespace brash::simulation {

/// The ice of a case at the start: its level ice, or the floes of `field.kind = "floes"`, from its file or generated
/// from its seed. A floe of `field.smallest_plate` or more is a plate, level ice that drifts. Other floes are for
/// Field::take_loose().
///
/// A floe has the thickness and the strength of the file, else the means of the variation over it. A plate varies about
/// the file's, else about the case's.
/// @throws InputError when the file is at fault, the field cannot be packed, or the structure or the shore begins in a
///         floe: the key or the place.
ice::Field laid_field(const model::Case& resolved);

/// The first velocity of floes and plates [m/s]. A field of floes drifts with the water that it begins in;
/// docs/theory/ice.md, (F7). Level ice begins at rest, and so do the floes beside it.
Vec2 drift_at_start(const model::Case& resolved);

/// Takes the floes beside the level ice of `field`. A field of floes has some, and ice of files may.
/// @throws InputError naming files and place when the structure begins in ice of files.
std::vector<ice::Plate> floes_beside(const model::Case& resolved, const structure::Hull& hull, ice::Field& field);

/// Height of walls and shores above and below the water [m]: floes that pile up stay within it.
double border_height(const model::Case& resolved);

/// Lays the walls of a field of floes and the shore of any field into `world`: ice to the floes and sheets that meet
/// them, and nothing to the structure.
/// @return the box around each.
/// @throws InputError when the file of the shore cannot be read.
std::vector<geometry::Extent> lay_borders(const model::Case& resolved, rigid_body::World& world);

}  // namespace brash::simulation
