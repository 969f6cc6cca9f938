// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/core/vec.hpp"

namespace brash::hydrodynamics {

/// The water that a structure pushes aside, as the potential flow around half a spheroid that moves below a rigid
/// surface: radius at the waterplane, depth from the displaced volume. No coefficient is chosen.
///
/// Valid where waves are low, U / sqrt(g 2 R) well below 1 (0.1 for the paper's cone), and off the wake: the water
/// behind the structure is taken to close like that ahead of it parts.
/// @see H. Lamb, Hydrodynamics, 6th ed., 1932, art. 114; docs/theory/hydrodynamics.md, (H10).
class StructureFlow {
 public:
  /// @param radius  of the structure at the waterplane [m], > 0.
  /// @param volume  displaced [m3], > 0.
  StructureFlow(double radius, double volume);

  /// Velocity of the water [m/s] at `point`, world axes from the structure's centre on the waterplane [m], when the
  /// structure moves at `velocity` along the surface. Inside the spheroid it is the structure's.
  Vec3 at(Vec3 point, Vec2 velocity) const;

 private:
  double radius_;
  double depth_;
  double strength_;  ///< R^2 H / (2 - alpha_0) [m3]
};

}  // namespace brash::hydrodynamics
