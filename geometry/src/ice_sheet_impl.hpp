// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "arrangement.hpp"
#include "brash/geometry/ice_sheet.hpp"
#include "free_edges.hpp"
#include "loops.hpp"

namespace brash::geometry {

struct IceSheet::Impl {
  FreeEdges boundary;
};

/// Throws unless `ring` is a counter-clockwise loop within the grid.
void expect_region(std::span<const Point> ring);

Polygon polygon_of(const Arrangement::Piece& piece);

/// The connected parts of a boundary that is made of nothing but these edges, as of IceSheet::polygons().
std::vector<Polygon> polygons_of(const FreeEdges::Change& boundary);

}  // namespace brash::geometry
