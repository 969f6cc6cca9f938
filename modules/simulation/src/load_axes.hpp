// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/core/vec.hpp"

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

}  // namespace brash::simulation
