// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "mesh.hpp"
#include "sheet_edge.hpp"

namespace brash::plate {

/// Element sizes and extent of a sheet, over l_c.
struct SheetSizes {
  double tip = 0.0;  ///< along loads, or tip_share of their length where that is less
  double tip_share = 0.0;
  double tip_corner = 0.0;  ///< at the ends of a load, over the size along it
  double root = 0.0;        ///< at re-entrant corners near a load
  double side = 0.0;        ///< along the edge near a load
  double centre = 0.0;      ///< along the x-axis, where the sheet breaks
  double patch = 0.0;       ///< at a patch load, or its radius where that is more
  double gradation = 0.0;   ///< growth with distance
  double near = 0.0;        ///< distance from loads and B within which `root` and `side` hold
  double largest = 0.0;
  double reach = 0.0;          ///< of the sheet
  double bending_reach = 0.0;  ///< distance from loads and the x-axis beyond which the sheet stays at rest
  EdgeTolerance tolerance;
  int membrane_order = 3;
};

SheetSizes sizes_of(Accuracy accuracy);

/// The domain of a sheet. Its segments number i < edge.points.size() - 1 join the points i and i + 1 of the edge.
struct SheetDomain {
  Domain domain;
  std::vector<Segment> focus;  ///< loads and the x-axis as far as the sheet may break there
};

tl::expected<SheetDomain, std::string> domain_of(const LoadedSheet& sheet, SheetEdge& edge, const SheetSizes& sizes);

}  // namespace brash::plate
