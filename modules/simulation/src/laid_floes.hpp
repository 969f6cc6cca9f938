// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/ice/field.hpp"
#include "brash/ice/variation.hpp"
#include "brash/model/case.hpp"
#include "brash/structure/hull.hpp"

namespace brash::simulation {

/// The floes of a case with `field.kind = "floes"`, from its file or generated from its seed, afloat.
///
/// A floe has the thickness and the strength of the file, else the means of `variation` over it.
/// @throws InputError when the file is at fault, the field cannot be packed, or the structure or the shore begins in a
///         floe: the key or the place.
std::vector<ice::Plate> laid_floes(const model::Case& resolved, const structure::Hull& hull,
                                   const ice::Variation& variation);

/// The floes beside the level ice of `field`, which takes them from there. It has some where files say where the ice
/// is.
/// @throws InputError naming files and place when the structure begins in ice of files.
std::vector<ice::Plate> floes_beside(const model::Case& resolved, const structure::Hull& hull, ice::Field& field);

}  // namespace brash::simulation
