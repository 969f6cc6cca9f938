// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brash/model/case.hpp"

namespace brash::report {

/// The ice of a case at the start and the shore: outline and holes of each piece, sheet frame [m].
struct PicturedIce {
  std::vector<std::vector<std::vector<Vec2>>> sheets;
  std::vector<std::vector<std::vector<Vec2>>> floes;
  std::vector<std::vector<std::vector<Vec2>>> land;
};

/// A case before its run, as SVG: lengthwise sections of the hull at the water and the ice, its waterlines from above,
/// and the field with the way of the structure.
std::string case_picture(const model::Case& resolved, const PicturedIce& of_start);

}  // namespace brash::report
