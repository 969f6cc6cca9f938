// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "brash/ice/plate.hpp"
#include "brash/model/case.hpp"
#include "brash/rigid_body/world.hpp"

namespace brash::edge {

/// Collision shapes of the level ice, in square tiles. Only tiles that a floe has come near are laid, and a cut renews
/// the tiles whose edge it moves. So neither the extent of the ice nor the length of its edge is in the cost of a step.
class SheetTiles {
 public:
  explicit SheetTiles(const model::Case& resolved) : case_(&resolved) {}

  /// Lays the tiles that meet the box from `lower` to `upper`, frame of the plate [m], where they are missing.
  /// @param frame  of the plate, where it is at the start of the step.
  /// @param sheet  the body of a plate that drifts.
  void lay(const ice::Plate& plate, rigid_body::World& world, Vec2 lower, Vec2 upper, const Pose& frame = {},
           BodyId sheet = rigid_body::kNoBody);
  /// Lays in the same way the tiles within `reach` of the edge of the plate, where that is within `reach` [m] of `box`.
  void lay_edge(const ice::Plate& plate, rigid_body::World& world, const geometry::Extent& box, double reach,
                const Pose& frame, BodyId sheet);
  /// Renews the tiles that are laid and meet the part of `plate` that has changed.
  void renew(const ice::Plate& plate, rigid_body::World& world, const geometry::Extent& changed, const Pose& frame = {},
             BodyId sheet = rigid_body::kNoBody);
  /// The tiles of a sheet move in the next step: to the pose of its frame, as that moves.
  void move(int level_ice, rigid_body::World& world, const Pose& frame, const Twist& twist);

  /// Number of the level ice that a body of its shape belongs to; nothing of another fixed body.
  std::optional<int> level_ice_of(BodyId part) const {
    const auto found = level_ice_of_.find(part);
    return found == level_ice_of_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  using Cell = std::pair<int, int>;
  const geometry::Extent& extent_of(const ice::Plate& plate);
  std::vector<BodyId> prisms(const ice::Plate& plate, rigid_body::World& world, Cell cell, const Pose& frame,
                             BodyId sheet);

  const model::Case* case_;
  std::map<int, geometry::Extent> extents_;  ///< of each level ice when it was first laid: it never grows
  std::map<int, std::map<Cell, std::vector<BodyId>>> parts_;  ///< of each level ice
  std::map<BodyId, int> level_ice_of_;
};

}  // namespace brash::edge
