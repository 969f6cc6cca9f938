// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "brash/model/records.hpp"
#include "brash/structure/hull.hpp"

namespace brash::structure {

/// The regions of a hull that goes ahead along its x: docs/theory/hulls.md, (K7).
class HullRegions {
 public:
  /// @param hull  has a waterline.
  explicit HullRegions(const Hull& hull);

  /// The region of a place on the hull.
  /// @param point    hull's frame [m].
  /// @param outward  unit normal there, hull's frame.
  model::HullRegion at(Vec3 point, Vec3 outward) const;

  double bow_end() const { return bow_end_; }              ///< x of the bow's after end [m]
  double shoulders_end() const { return shoulders_end_; }  ///< likewise of the shoulders
  double stern_start() const { return stern_start_; }      ///< x of the stern's fore end [m]

 private:
  double bow_end_ = 0.0;
  double shoulders_end_ = 0.0;
  double stern_start_ = 0.0;
};

/// The regions of a ship or a mesh with a waterline. Other shapes have none.
std::optional<HullRegions> regions_of(const model::Shape& shape, const Hull& hull);

}  // namespace brash::structure
