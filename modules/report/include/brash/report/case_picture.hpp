// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brash/model/case.hpp"

namespace brash::report {

/// A case before its run, as SVG: lengthwise sections of the hull at the water and the ice, its waterlines from above,
/// and the field with the way of the structure.
/// @param floes  of a field of floes: outline and holes of each, sheet frame [m].
std::string case_picture(const model::Case& resolved, const std::vector<std::vector<std::vector<Vec2>>>& floes = {});

}  // namespace brash::report
