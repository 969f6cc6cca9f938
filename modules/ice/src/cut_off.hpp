// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "brash/geometry/ice_sheet.hpp"

namespace brash::ice {

/// The ice that a crack cuts off, with its outline in the water a little outside the crack's ends.
struct CutOff {
  std::vector<Vec2> region;  ///< simple, counter-clockwise [m]
  std::vector<Vec2> crack;   ///< from free edge to free edge [m]
};

/// The ice between a crack and the free edge around `tip`.
/// @param crack  from outside the ice, or just short of it, to outside the ice, past the far side of `tip` [m].
/// @return nothing where the crack does not end on the piece of free edge that `tip` lies on, on both sides of it, or
///         where the region would cross itself.
std::optional<CutOff> cut_off(const geometry::IceSheet& sheet, Vec2 tip, const std::vector<Vec2>& crack);

/// The point at the share `share` of a polyline's length.
Vec2 along(const std::vector<Vec2>& line, double share);

}  // namespace brash::ice
