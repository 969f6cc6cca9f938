// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/core/constants.hpp"

namespace brash::standards {

/// A floating plate of ice. SI.
struct PlateInput {
  double thickness = 0.0;         ///< h [m], > 0
  double youngs_modulus = 0.0;    ///< E [Pa], > 0
  double poisson_ratio = 0.3;     ///< nu [-], in [0, 0.5)
  double water_density = 1025.0;  ///< rho_w [kg/m3], > 0
  double gravity = kGravity;      ///< g [m/s2]
};

/// Characteristic length of a floating plate [m]:
///
///   l_c = [E h^3/(12 (1 - nu^2) rho_w g)]^(1/4)                         docs/theory/standards.md, (L9)
///
/// @see M. Hetenyi, Beams on Elastic Foundation, 1946.
double characteristic_length(const PlateInput& input);

/// Distance [m] from a straight free edge to the largest bending moment of a plate that is loaded evenly along the
/// edge:
///
///   l_b = (pi/4) sqrt(2) l_c = 1.111 l_c                                docs/theory/standards.md, (L10)
///
/// It is the breaking length of a wide, slow slope. Local loads and fast ones break shorter pieces.
///
/// @see M. Hetenyi, Beams on Elastic Foundation, 1946: the moment exp(-b x) sin(b x) with b = 1/(sqrt(2) l_c).
double breaking_length(const PlateInput& input);

}  // namespace brash::standards
