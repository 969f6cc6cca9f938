// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/core/vec.hpp"
#include "brash/model/case.hpp"

namespace brash::simulation {

/// The ice of a field at the start of a run, before an initial crack. Each outline comes with its holes, sheet frame
/// [m].
struct InitialField {
  std::vector<std::vector<std::vector<Vec2>>> floes;
  double area = 0.0;                                   ///< of all floes [m2]
  std::vector<std::vector<std::vector<Vec2>>> sheets;  ///< level ice in its connected parts
  double sheet_area = 0.0;                             ///< [m2]
  std::vector<std::vector<std::vector<Vec2>>> land;    ///< of the shore
};

/// The land of a case, field.shore: each outline with its holes, sheet frame [m]; empty without one.
/// @throws InputError when its file cannot be read.
std::vector<std::vector<std::vector<Vec2>>> land_outlines(const model::Case& resolved);

/// The field without its land [m2].
/// @throws InputError when the file of the land cannot be read.
double open_water(const model::Case& resolved);

/// The ice that a run of the case would begin with.
/// @throws InputError when they cannot be laid: file, key or place.
InitialField initial_field(const model::Case& resolved);

}  // namespace brash::simulation
