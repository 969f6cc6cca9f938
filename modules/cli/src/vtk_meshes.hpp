// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "brash/geometry/polygon.hpp"
#include "brash/io/vtk.hpp"

namespace brash::cli {

/// Adds the closed surface of the prism over `polygon` between two heights [m], placed by `pose`.
///
/// Top and bottom are the polygon's convex parts and share all edges with the sides.
/// @return how many faces were added.
std::size_t add_prism(io::PolyData& data, const geometry::Polygon& polygon, double bottom, double top,
                      const Pose& pose = {});

/// Polygons of rings [m] with the ice on their left, each outline followed by its holes.
std::vector<geometry::Polygon> polygons_of(std::span<const std::vector<Vec2>> rings);

}  // namespace brash::cli
