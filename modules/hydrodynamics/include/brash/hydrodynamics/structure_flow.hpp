// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/core/vec.hpp"

namespace brash::hydrodynamics {

/// The water that a structure pushes aside, as the potential flow around half an ellipsoid that moves below a rigid
/// surface. No coefficient is chosen.
///
/// Valid where waves are low, U / sqrt(g L) well below 1 (0.1 for the paper's cone), and off the wake: the water behind
/// the structure is taken to close like that ahead of it parts.
/// @see H. Lamb, Hydrodynamics, 6th ed., 1932, art. 114; docs/theory/water.md, (H10).
class StructureFlow {
 public:
  /// @param semi_axes  of the ellipsoid along x, y and downwards [m], > 0.
  explicit StructureFlow(Vec3 semi_axes);

  /// Velocity of the water [m/s] at `point`, in axes along the ellipsoid's from its centre on the waterplane [m], when
  /// it moves at `velocity` along the surface. Inside the ellipsoid, where water is between it and the hull, it is the
  /// velocity at the surface on the same ray from the centre: it runs along the hull there, and continuously.
  Vec3 at(Vec3 point, Vec2 velocity) const;

  /// Acceleration of the water there, Du/Dt [m/s2], while `velocity` stays (docs/theory/water.md, (H22)).
  Vec3 acceleration(Vec3 point, Vec2 velocity) const;

 private:
  Vec3 squares_;   ///< of the semi-axes [m2]
  Vec2 strength_;  ///< abc / (2 - alpha_0), abc / (2 - beta_0) [m3]
};

}  // namespace brash::hydrodynamics
