// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "brash/core/constants.hpp"
#include "brash/structure/motion.hpp"

namespace brash::structure::testing {

constexpr double kDensity = 1025.0;  // [kg/m3]

/// A hull and its motion; the hull outlives it.
struct Moving {
  Moving(const model::Shape& shape, const model::Motion& motion, double time_step, Vec2 current = {},
         model::MotionFrame frame = model::MotionFrame::kStructureMoves)
      : hull(make_hull(shape)) {
    resolved.structure = {.shape = shape, .motion = motion, .frame = frame, .start_distance = 7.0};
    resolved.time.step = time_step;
    resolved.water = {.density = kDensity, .current = current};
    motion_ = make_motion(resolved, *hull);
  }

  Motion& operator*() const { return *motion_; }
  Motion* operator->() const { return motion_.get(); }

  /// One step, in which the load of the step before acts.
  void step(const Wrench& load = {}) {
    motion_->advance(1.0);
    motion_->bear(load);
  }
  void steps(int n) {
    for (int i = 0; i < n; ++i) step();
  }

  model::Case resolved;
  std::unique_ptr<const Hull> hull;

 private:
  std::unique_ptr<Motion> motion_;
};

/// 20 m long, 8 m wide, 3 m deep in the water.
inline model::Plane box() {
  return {.angle = 0.5 * kPi, .waterline_width = 8.0, .length = 20.0, .height = 5.0, .height_under_water = 3.0};
}

}  // namespace brash::structure::testing
