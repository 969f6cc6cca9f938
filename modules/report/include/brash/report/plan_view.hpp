// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brash/core/vec.hpp"
#include "brash/model/case.hpp"
#include "brash/model/records.hpp"

namespace brash::report {

/// The end of a run seen from above, as SVG: the land, the sheet with its channel, every floe where it floats (those
/// under the sheet's level darker), the structure at its waterline, the points where the ice broke, and a scale.
/// @param land  as in RunSource.
std::string plan_view(const model::Case& resolved, const model::RunResults& results,
                      const std::vector<std::vector<std::vector<Vec2>>>& land);

}  // namespace brash::report
