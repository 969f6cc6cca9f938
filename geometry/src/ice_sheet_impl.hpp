// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "arrangement.hpp"
#include "brash/geometry/ice_sheet.hpp"
#include "brash/geometry/polygon.hpp"
#include "free_edges.hpp"

namespace brash::geometry {

/// The simple loops that a closed chain with repeated vertices consists of.
std::vector<Ring> simple_loops(Ring ring);

/// The connected region whose boundary is these chains, the region on their left.
///
/// Chains may come through a vertex more than once. Each ring starts at its smallest vertex, and the holes are sorted.
Polygon polygon_of(const std::vector<Ring>& boundary);

struct IceSheet::Impl {
  FreeEdges boundary;
};

/// Throws unless `ring` is a counter-clockwise loop within the grid.
void expect_region(std::span<const Point> ring);

Polygon polygon_of(const Arrangement::Piece& piece);

/// The connected parts of a boundary that is made of nothing but these edges, as of IceSheet::polygons().
std::vector<Polygon> polygons_of(const FreeEdges::Change& boundary);

}  // namespace brash::geometry
