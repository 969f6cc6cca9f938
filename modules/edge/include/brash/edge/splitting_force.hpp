// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "brash/edge/edge_contact.hpp"
#include "brash/failure/splitting.hpp"

namespace brash::edge {

/// The structure's load in the plane of a sheet, as one wedge that drives it apart; frame of the sheet.
struct SplittingForce {
  Vec2 at{};             ///< where the crack begins: on the edge, at the strongest contact [m]
  Vec2 towards{};        ///< unit vector along the crack, with the whole force in the plane
  double push = 0.0;     ///< N: that force [N]
  double opening = 0.0;  ///< P: the smaller of the forces across the crack to one side and to the other [N]
};

/// The contacts of the structure with level ice number `level_ice` as one wedge (G6); nothing where they do not push.
std::optional<SplittingForce> splitting_force(std::span<const EdgeContact> contacts, int level_ice);

/// The rectangle that represents a sheet: as long as the crack's line to the far border, and twice as broad as the
/// narrower side of the ice ahead. Nothing without ice ahead and on both sides.
std::optional<failure::SplitPlate> rectangle_ahead(const geometry::IceSheet& sheet, const SplittingForce& force);

}  // namespace brash::edge
