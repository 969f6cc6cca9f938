// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "brash/core/vec.hpp"
#include "random_placement.hpp"

namespace brash::ice {

/// A site of a power diagram: its cell holds the points x with |x - place|^2 - weight least of all sites.
struct Site {
  Vec2 place{};         ///< [m]
  double weight = 0.0;  ///< [m2]
};

/// The cells of a power diagram within `domain`, whose areas are `areas`: the weights are solved by Newton's method.
///
/// @param sites  in the domain, each with a cell at its first weight.
/// @param areas  of the cells, which sum to the area of the domain [m2].
/// @return the cells, convex, counter-clockwise [m]; areas to kAreaError.
/// @see docs/theory/ice.md, (F4)
std::vector<std::vector<Vec2>> cells_of_areas(const Domain& domain, std::vector<Site> sites,
                                              std::span<const double> areas);

/// Relative error of the areas at which the iteration ends.
inline constexpr double kAreaError = 1e-6;

double area_of(std::span<const Vec2> ring);    ///< [m2]
Vec2 centroid_of(std::span<const Vec2> ring);  ///< [m]

}  // namespace brash::ice
