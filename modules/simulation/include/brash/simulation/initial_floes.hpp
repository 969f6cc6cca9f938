// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/core/vec.hpp"
#include "brash/model/case.hpp"

namespace brash::simulation {

/// The floes of a field at the start of a run.
struct InitialField {
  std::vector<std::vector<std::vector<Vec2>>> floes;  ///< outline and holes of each, sheet frame [m]
  double area = 0.0;                                  ///< of all [m2]
};

/// The floes that a run of the case would begin with; none in level ice.
/// @throws InputError when they cannot be laid: file, key or place.
InitialField initial_field(const model::Case& resolved);

}  // namespace brash::simulation
