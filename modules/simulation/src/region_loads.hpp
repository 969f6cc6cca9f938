// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "brash/core/vec.hpp"
#include "brash/model/records.hpp"
#include "brash/structure/regions.hpp"

namespace brash::simulation {

/// The axes of loads on a structure: x against its heading, y to starboard, z upwards. They heel and pitch with
/// nothing.
class LoadAxes {
 public:
  explicit LoadAxes(const Pose& structure) {
    const Vec2 bow = plan(rotate(structure.rotation, {1.0, 0.0, 0.0}));
    if (norm(bow) > 0.0) ahead_ = normalized(bow);
  }

  /// A load in these axes. A part of it that is zero stays +0.
  Wrench operator()(const Wrench& w) const { return {turned(w.force), turned(w.moment)}; }

 private:
  Vec3 turned(Vec3 v) const { return {0.0 - dot(ahead_, plan(v)), 0.0 - cross(ahead_, plan(v)), v.z}; }

  Vec2 ahead_{1.0, 0.0};
};

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
