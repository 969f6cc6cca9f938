// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

#include "brash/geometry/ice_sheet.hpp"

namespace brash::geometry {

/// "line L, column C: `what`", counted from 1, for the byte at `offset` of `text`.
GeometryError error_at(std::string_view text, std::size_t offset, std::string_view what);

/// The first position beyond +-kMaxCoordinate or not finite, in words, if there is one.
std::optional<std::string> fault_of_positions(std::span<const Vec2> positions);

/// The grid ring through the closed list of `positions` [m], counter-clockwise, or clockwise for a hole.
/// @return the ring, or the error in it.
tl::expected<Ring, std::string> ring_from_text(std::span<const Vec2> positions, bool is_hole);

/// "x y" or "x,y" with 17 significant digits [m].
std::string position_to_text(Point point, char separator);

}  // namespace brash::geometry
