// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "mesh.hpp"
#include "profiles.hpp"
#include "sheet_edge.hpp"

namespace brash::plate {

/// Element sizes and extent of a sheet, over l_c.
struct SheetSizes {
  double tip = 0.0;  ///< along loads, or tip_share of their length where that is less
  double tip_share = 0.0;
  double tip_corner = 0.0;      ///< at the ends of a load, over the size along it
  double root = 0.0;            ///< at re-entrant corners near a load
  double side = 0.0;            ///< along the edge near a load
  double centre = 0.0;          ///< along the x-axis, where the sheet breaks
  double crack = 0.0;           ///< the same where a crack runs there: its two sides are fitted apart
  double distance_share = 0.0;  ///< features are no finer than this share of their distance from the places looked at
  double gradation = 0.0;       ///< growth with distance
  double near = 0.0;            ///< distance from loads and B within which `root` and `side` hold
  double reach = 0.0;           ///< of the sheet
  double bending_reach = 0.0;   ///< distance from loads and the x-axis beyond which the sheet stays at rest
  EdgeTolerance tolerance;
  std::size_t most_vertices = 0;  ///< a mesh with more is tried again on a simpler edge, then given up
  int membrane_order = 3;
  int bending_order = kOrder;
  /// Fewest triangles to which the stress is fitted. On a coarse mesh more triangles smooth it too much.
  std::size_t smallest_patch = 3;
};

SheetSizes sizes_of(Accuracy accuracy);

/// The domain of a sheet. Its segments number i < edge.points.size() - 1 join the points i and i + 1 of the edge.
struct SheetDomain {
  Domain domain;
  std::vector<Segment> lines;  ///< places looked at: the x-axis as far as the sheet may break there, patch loads
  std::vector<Segment> focus;  ///< these and the edge loads
};

tl::expected<SheetDomain, std::string> domain_of(const LoadedSheet& sheet, SheetEdge& edge, const SheetSizes& sizes);

}  // namespace brash::plate
