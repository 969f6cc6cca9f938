// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "brash/model/case.hpp"
#include "brash/statistics/random.hpp"

namespace brash::ice {

/// The mean area of a floe, the mean of L^2 over the law of sizes L [m2]. docs/theory/ice.md, (F2), (F3).
double mean_area(const model::FloeSizes& law);

/// The first size that the case states for the law: the least, the median, or the first of the list [m].
double stated_size(const model::FloeSizes& law);

/// Draws areas of floes by a law of sizes until their sum is as near to `area` as it comes [m2].
/// @return the areas, or nothing when there would be more than `most`.
std::optional<std::vector<double>> draw_areas(const model::FloeSizes& law, double area, std::size_t most,
                                              statistics::RandomStream& random);

}  // namespace brash::ice
