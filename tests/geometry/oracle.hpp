// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts and polygons against CGAL's exact Boolean operations.
#pragma once

#include <cmath>
#include <vector>

#include "brash/geometry/ice_sheet.hpp"

namespace brash::geometry::oracle {

/// How far a cut is from the exact outcome [m2]: area in exactly one of the two, for the sheet and for the pieces, and
/// the largest rounding error. Pieces that overlap count too.
struct Deviation {
  double sheet = 0.0;
  double pieces = 0.0;
  double allowed = 0.0;
  bool is_allowed() const { return std::abs(sheet) <= allowed && std::abs(pieces) <= allowed; }
};

/// Of a cut that left `sheet` of the polygons `before`.
Deviation deviation(const std::vector<Polygon>& before, const Ring& region, const IceSheet& sheet, const Cut& cut);

/// Of the ice outside the region [m2].
double area_outside(const std::vector<Polygon>& ice, const Ring& region);

/// Whether polygons overlap nowhere: their union is as large as the sum of their areas.
bool are_disjoint(const std::vector<Polygon>& polygons);

}  // namespace brash::geometry::oracle
