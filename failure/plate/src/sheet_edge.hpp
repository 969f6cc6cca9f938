// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "brash/plate/sheet.hpp"

namespace brash::plate {

/// The free edge as it is meshed.
struct SheetEdge {
  std::vector<Vec2> points;
  std::vector<std::pair<std::size_t, std::size_t>> loads;  ///< first and last point of each edge load
  std::optional<std::size_t> origin;                       ///< the point at B; nothing where the edge misses B
};

/// How far the edge may be simplified: by `near` up to the distance 1 of the loads and B, and beyond by `growth` more
/// for each unit of distance; over l_c.
struct EdgeTolerance {
  double near = 0.02;
  double growth = 0.0;
  /// The last resort: necks and narrow mouths are closed also if the ice behind them is loaded or the bay is wide. Its
  /// loads move to the edge next to it.
  bool at_any_price = false;
};

/// Makes the ends of the loads and B points of the edge, straight between the ends of a load, and leaves out what is
/// small: points (Douglas and Peucker), necks and slivers of ice.
///
/// @return the edge, which does not touch itself, or why there is none.
tl::expected<SheetEdge, std::string> simplified_edge(const LoadedSheet& sheet, EdgeTolerance tolerance);

/// Distance of a place from a straight stretch.
double distance_to_stretch(Vec2 place, Vec2 from, Vec2 to);

}  // namespace brash::plate
