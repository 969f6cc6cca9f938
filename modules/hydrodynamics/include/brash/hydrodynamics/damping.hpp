// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/core/vec.hpp"

namespace brash::hydrodynamics {

/// Time step, inertia and weight of a floe: all that moves and holds it in a step besides the water.
struct StepInertia {
  double dt = 0.0;              ///< [s]; 0: the drag of this instant
  double mass = 1.0;            ///< with added mass [kg], > 0
  Vec3 inertia{1.0, 1.0, 1.0};  ///< principal moments in the body frame, with added mass [kg m2], > 0
  double weight = 0.0;          ///< [N]
  double added_across = 0.0;    ///< mass along the body's z axis beyond `mass` [kg], >= 0
};

/// Linear dampers of faces, each along the normal n_i in the point x_i, by their moments: with w_i = x_i x n_i
///
///   f = -sum c_i n_i (n_i . v + w_i . Omega),   tau = -sum c_i w_i (n_i . v + w_i . Omega)
///
/// Body frame, about its origin.
struct NormalDamping {
  Vec3 squares{};           ///< sum c n n, xx, yy, zz [kg/s]
  Vec3 products{};          ///< sum c n n, yz, zx, xy [kg/s]
  Vec3 with_x{};            ///< sum c n_x w [kg m/s]
  Vec3 with_y{};            ///< sum c n_y w
  Vec3 with_z{};            ///< sum c n_z w
  Vec3 turning_squares{};   ///< sum c w w, xx, yy, zz [kg m2/s]
  Vec3 turning_products{};  ///< sum c w w, yz, zx, xy [kg m2/s]

  NormalDamping scaled(double factor) const;
  /// The load on a body that moves with `twist`.
  Wrench load(const Twist& twist) const;

  friend bool operator==(const NormalDamping&, const NormalDamping&) = default;
};

/// Linear dampers in points of a body, along normals and against its rotation, by their moments: the damping matrix
///
///   f = -sum c_i (v + Omega x x_i),   tau = -sum c_i x_i x (v + Omega x x_i) - b Omega,   and NormalDamping
///
/// is symmetric and takes energy from every motion. Body frame, about its origin.
struct Damping {
  double sum = 0.0;       ///< sum c [kg/s]
  Vec3 first{};           ///< sum c x [kg m/s]
  Vec3 squares{};         ///< sum c xx, yy, zz [kg m2/s]
  Vec3 products{};        ///< sum c yz, zx, xy [kg m2/s]
  double rotation = 0.0;  ///< b [kg m2/s]
  NormalDamping normal{};

  /// A damper of `coefficient` [kg/s], >= 0, in the point `at`.
  void add(double coefficient, Vec3 at) {
    sum += coefficient;
    const Vec3 moment = coefficient * at;
    first += moment;
    squares += {moment.x * at.x, moment.y * at.y, moment.z * at.z};
    products += {moment.y * at.z, moment.z * at.x, moment.x * at.y};
  }

  Damping scaled(double factor) const;

  /// The load on a body that moves with `twist`.
  Wrench load(const Twist& twist) const;

  /// Velocity after a step in which the dampers and `load` act on a floe that moved with `twist`: the dampers at the
  /// velocity sought (implicit Euler).
  Twist velocity_after(const Twist& twist, const Wrench& load, const StepInertia& step) const;

  friend bool operator==(const Damping&, const Damping&) = default;

 private:
  Twist velocity_after_isotropic(const Twist& twist, const Wrench& load, const StepInertia& step) const;
};

}  // namespace brash::hydrodynamics
