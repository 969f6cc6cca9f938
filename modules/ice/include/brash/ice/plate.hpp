// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "brash/failure/criterion.hpp"
#include "brash/geometry/ice_sheet.hpp"

namespace brash::ice {

/// How a plate is held.
enum class Hold {
  kFast,      ///< level ice with fixed borders
  kDrifting,  ///< level ice with free borders
  kAfloat     ///< a floe
};

/// A connected polygon of a plate, as a checkpoint keeps it.
struct PlatePart {
  std::int64_t level_ice = 0;      ///< Plate::level_ice()
  double thickness = 0.0;          ///< of Plate::ice()
  double flexural_strength = 0.0;  ///< of Plate::ice()
  geometry::Polygon outline;

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("level_ice", "1", "number of the level ice that it is part of, or was", self.level_ice);
    visit("thickness", "m", "mean thickness", self.thickness);
    visit("flexural_strength", "Pa", "mean flexural strength", self.flexural_strength);
    visit("outline", "1", "outline, frame of that level ice", self.outline);
  }
};

/// A piece of ice that can break: level ice or a floe. A piece that breaks off a plate is a plate
/// again.
///
/// Its outline is exact, in its own frame. The frame of level ice is the world's while the ice is fast. A piece keeps
/// the frame of the level ice that it broke off; its body is the business of the caller who lets it float.
class Plate {
 public:
  /// @param level_ice  its number among the field's level ice.
  /// @param outline    simple and disjoint.
  Plate(int level_ice, Hold hold, const failure::IceProperties& ice, std::vector<geometry::Polygon> outline);

  /// A piece of this plate, afloat.
  Plate piece(geometry::Polygon outline, const failure::IceProperties& ice) const;
  /// A piece of this plate, afloat, of the same ice.
  Plate piece(geometry::Polygon outline) const { return piece(std::move(outline), ice_); }

  int level_ice() const { return level_ice_; }
  Hold hold() const { return hold_; }
  const failure::IceProperties& ice() const { return ice_; }
  /// The ice that is left of it now.
  std::vector<geometry::Polygon> outline() const;
  geometry::ExactArea area() const;
  /// Whether no ice is left of it.
  bool is_gone() const;

  /// Its edges with their index, for cuts and questions about the free edge. The index is made on the first call: most
  /// floes never need it.
  /// @throws ContractViolation when the outline is not simple.
  const geometry::IceSheet& sheet() const;
  geometry::IceSheet& sheet();

 private:
  int level_ice_;
  Hold hold_;
  failure::IceProperties ice_;
  mutable std::vector<geometry::Polygon> outline_;  ///< empty once there is a sheet
  mutable std::optional<geometry::IceSheet> sheet_;
};

}  // namespace brash::ice
