// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "brash/model/records.hpp"
#include "brash/structure/hull.hpp"

namespace brash::structure {

/// The regions of a hull that goes ahead along its x: docs/theory/structures.md, (K7).
class HullRegions {
 public:
  /// @param hull  has a waterline.
  explicit HullRegions(const Hull& hull);

  /// The region of a place on the hull.
  /// @param point    hull's frame [m].
  /// @param outward  unit normal there, hull's frame.
  model::HullRegion at(Vec3 point, Vec3 outward) const;

  double bow_end() const { return bow_end_; }              ///< x of the bow's after end [m]
  double shoulders_end() const { return shoulders_end_; }  ///< x of the shoulders' after end [m]
  double stern_start() const { return stern_start_; }      ///< x of the stern's fore end [m]

 private:
  double bow_end_ = 0.0;
  double shoulders_end_ = 0.0;
  double stern_start_ = 0.0;
};

/// The legs of a structure as its regions. The boxes around them do not overlap.
class LegRegions {
 public:
  explicit LegRegions(const HullCopies& legs);

  /// The number of the leg whose box in plan holds `point` or is nearest to it; structure's frame [m].
  std::size_t at(Vec3 point) const;

 private:
  Vec2 least_, most_;  ///< of a leg, from its origin [m]
  std::vector<Vec2> places_;
};

/// The regions of a structure, as numbers in model::RegionLoads.
class Regions {
 public:
  explicit Regions(HullRegions regions) : regions_(regions) {}
  explicit Regions(LegRegions regions) : regions_(std::move(regions)) {}

  /// @param point    structure's frame [m].
  /// @param outward  unit normal of the structure there, structure's frame.
  std::size_t at(Vec3 point, Vec3 outward) const;

 private:
  std::variant<HullRegions, LegRegions> regions_;
};

/// The legs of a structure that has any; the regions of a ship or a mesh with a waterline. Others have none.
std::optional<Regions> regions_of(const model::StructureSection& structure, const Hull& hull);

}  // namespace brash::structure
