// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "brash/geometry/ice_sheet.hpp"
#include "brash/rigid_body/world.hpp"

namespace brash::simulation {

/// The fixed sheet's collision shapes, in square tiles: only those that a floe has come near are laid, and a cut renews
/// those whose edge it moves. So neither the length of the sheet nor that of its edge is in the cost of a step.
class SheetTiles {
 public:
  /// Tiles are convex prisms between the heights `bottom` and `top` [m].
  SheetTiles(double bottom, double top) : bottom_(bottom), top_(top) {}

  /// Lays the tiles that meet the box from `lower` to `upper` [m], where they are missing.
  void lay(const geometry::IceSheet& sheet, rigid_body::World& world, Vec2 lower, Vec2 upper);
  /// Renews the tiles that are laid and meet the part of the sheet that has changed.
  void renew(const geometry::IceSheet& sheet, rigid_body::World& world, const geometry::Extent& changed);

 private:
  using Cell = std::pair<int, int>;
  std::vector<BodyId> prisms(const geometry::IceSheet& sheet, rigid_body::World& world, Cell cell) const;

  std::map<Cell, std::vector<BodyId>> parts_;
  double bottom_;
  double top_;
};

}  // namespace brash::simulation
