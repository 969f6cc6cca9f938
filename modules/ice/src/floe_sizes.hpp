// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "brash/model/case.hpp"
#include "brash/statistics/random.hpp"

namespace brash::ice {

/// Draws areas of floes by a law of sizes until their sum is as near to `area` as it comes [m2].
/// @return the areas, or nothing when there would be more than `most`.
std::optional<std::vector<double>> draw_areas(const model::FloeSizes& law, double area, std::size_t most,
                                              statistics::RandomStream& random);

}  // namespace brash::ice
