// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "brash/geometry/ice_sheet.hpp"
#include "brash/rigid_body/world.hpp"

namespace brash::simulation {

/// The fixed sheet's collision shapes, in square tiles: a cut renews the tiles that it touches and no others.
class SheetTiles {
 public:
  /// Tiles the sheet with convex prisms between the heights `bottom` and `top` [m].
  SheetTiles(const geometry::IceSheet& sheet, rigid_body::World& world, double bottom, double top);

  /// Renews the tiles that meet the box from `lower` to `upper` [m].
  void renew(const geometry::IceSheet& sheet, rigid_body::World& world, Vec2 lower, Vec2 upper);

 private:
  using Cell = std::pair<int, int>;
  std::map<Cell, std::vector<BodyId>> parts_;
  double bottom_;
  double top_;
};

}  // namespace brash::simulation
