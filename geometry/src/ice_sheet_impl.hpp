// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "arrangement.hpp"
#include "brash/geometry/ice_sheet.hpp"
#include "free_edges.hpp"

namespace brash::geometry {

struct IceSheet::Impl {
  FreeEdges boundary;

  /// The polygon of the part with the given loops.
  Polygon part(const std::vector<Ring>& loops) const;
};

/// Throws unless `ring` is a counter-clockwise loop within the grid.
void expect_region(std::span<const Point> ring);

/// The boundaries of the pieces of ice inside the region; cracks that split nothing are left out.
struct PieceCycles {
  std::vector<std::vector<int>> cycles;
  /// Cracks that do split, edge by edge.
  std::vector<Crack> splitting;
  /// True when the other cracks have left a node that would not be there without them.
  bool has_traces = false;
};
PieceCycles trace_pieces(const Arrangement& arrangement);

/// The free edge after the region of the arrangement has gone, as a change of the boundary.
struct SheetChange {
  FreeEdges::Change change;
  Int128 twice_area = 0;  ///< What the change adds to twice the area of the sheet.
};
SheetChange change_of(const Arrangement& arrangement, const FreeEdges& boundary);

}  // namespace brash::geometry
