// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/core/vec.hpp"
#include "brash/hydrodynamics/water.hpp"

namespace brash::hydrodynamics {

/// Linear dampers in points of a body and against its rotation, by their moments: the damping matrix
///
///   f = -sum c_i (v + Omega x x_i),   tau = -sum c_i x_i x (v + Omega x x_i) - b Omega
///
/// is symmetric and takes energy from every motion. Body frame, about its origin.
class Damping {
 public:
  Damping() = default;
  /// Dampers by the sums of c; c x; c xx, yy, zz; c yz, zx, xy.
  Damping(double sum, Vec3 first, Vec3 squares, Vec3 products)
      : sum_(sum), first_(first), squares_(squares), products_(products) {}

  /// A damper of `coefficient` [kg/s], >= 0, in the point `at`.
  void add(double coefficient, Vec3 at) {
    sum_ += coefficient;
    const Vec3 moment = coefficient * at;
    first_ += moment;
    squares_ += {moment.x * at.x, moment.y * at.y, moment.z * at.z};
    products_ += {moment.y * at.z, moment.z * at.x, moment.x * at.y};
  }
  /// A damper of `coefficient` [kg m2/s], >= 0, against rotation about any axis.
  void add_rotation(double coefficient) { rotation_ += coefficient; }

  /// The load on a body that moves with `twist`.
  Wrench load(const Twist& twist) const;

  /// Velocity after a step in which the dampers and `load` act on a floe that moved with `twist`: the dampers at the
  /// velocity sought (implicit Euler).
  Twist velocity_after(const Twist& twist, const Wrench& load, const StepInertia& step) const;

 private:
  double sum_ = 0.0;
  Vec3 first_{};     ///< sum c x
  Vec3 squares_{};   ///< sum c xx, yy, zz
  Vec3 products_{};  ///< sum c yz, zx, xy
  double rotation_ = 0.0;
};

}  // namespace brash::hydrodynamics
