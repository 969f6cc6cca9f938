// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "brash/model/records.hpp"
#include "brash/structure/regions.hpp"
#include "load_axes.hpp"

namespace brash::simulation {

/// The loads of a step by region of the structure; nothing for shapes without regions.
class RegionLoadSums {
 public:
  explicit RegionLoadSums(const std::optional<const structure::Regions>& regions) : regions_(&regions) {}

  /// A force on the structure, sheet axes [N].
  /// @param point    where it acts [m].
  /// @param outward  unit normal of the hull there, sheet axes.
  void add_crushing(const Pose& structure, Vec3 point, Vec3 outward, Vec3 force);
  void add_floe(const Pose& structure, Vec3 point, Vec3 outward, Vec3 force);

  model::RegionLoads in(const LoadAxes& axes) const;

 private:
  model::RegionLoad& at(const Pose& structure, Vec3 point, Vec3 outward);

  const std::optional<const structure::Regions>* regions_;
  model::RegionLoads sums_;  ///< sheet axes
};

}  // namespace brash::simulation
