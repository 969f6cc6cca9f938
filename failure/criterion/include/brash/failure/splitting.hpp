// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace brash::failure {

/// The load on a plate afloat that would split it in its plane from a contact on its edge.
struct SplittingLoad {
  double opening = 0.0;    ///< P: the pair of forces across the crack, at its mouth [N]
  double push = 0.0;       ///< N: the force along the crack, which accelerates the plate [N]
  double thickness = 0.0;  ///< h [m]
};

/// A rectangle with the crack in its middle.
struct SplitPlate {
  double length = 0.0;   ///< W: from the contact along the crack to the far border [m]
  double breadth = 0.0;  ///< B: across the crack [m]
};

/// Stress intensity K_I of a crack that is `share` of the plate's length deep [Pa m^0.5]. Negative: it is closed.
///
/// Plane stress, linear elastic, no inertia of the parts against each other. Breadths from an eighth of the length on,
/// cracks from 1 to 90 % of it; the nearest of these beyond. docs/theory/fracture-of-floes.md, (G7).
double stress_intensity(const SplittingLoad& load, const SplitPlate& plate, double share);

/// The least of it on the crack's way through the plate, of any breadth. The load splits the plate where it exceeds the
/// toughness (G8).
double least_intensity(const SplittingLoad& load, const SplitPlate& plate);

/// The pair of forces that splits a plate without a push [N]; (G9).
///
/// @param toughness  K_IC [Pa m^0.5].
double splitting_force(double toughness, double thickness, const SplitPlate& plate);

}  // namespace brash::failure
