// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "brash/geometry/ice_sheet.hpp"

namespace brash::geometry {

/// Cracks that reach 0.1 um beyond their free ends, which no other crack has too.
///
/// A line that is drawn to an edge or to another line may miss it by the rounding of all three to the grid, and would
/// part nothing. The overshoot parts nothing on its own.
std::vector<Crack> beyond_free_ends(std::vector<Crack> cracks);

/// Calls `visit(from, to)` for the ends of each edge of a polygon.
template <typename Visit>
void visit_edges(const Polygon& polygon, Visit&& visit) {
  const auto visit_ring = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
  };
  visit_ring(polygon.outline);
  for (const Ring& hole : polygon.holes) visit_ring(hole);
}

/// [m]
double distance_to_edges(const Polygon& polygon, Vec2 place);

/// A stretch of a line inside the ice that parts nothing [m].
struct Tail {
  Vec2 from;
  Vec2 to;  ///< its end in the ice
};

/// Whether the line from `a` to `b` [m] passes a box by: then no polygon within it has a tail of the line.
bool are_apart(const Extent& box, Vec2 a, Vec2 b);

/// A stretch of the line from `a` to `b` [m] in the inside of `part`, between two crossings of its edges. Stretches of
/// less than a millimetre are errors of drawing.
/// @param ice  the same part.
std::optional<Tail> tail_in(const Polygon& part, const IceSheet& ice, Vec2 a, Vec2 b);

}  // namespace brash::geometry
