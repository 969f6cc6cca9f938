// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/core/constants.hpp"

namespace brash::standards {

/// A ship's hull in level ice. SI.
struct JeongInput {
  double breadth = 0.0;            ///< B [m], > 0
  double draught = 0.0;            ///< T [m], > 0
  double thickness = 0.0;          ///< h, of the ice [m], > 0
  double speed = 0.0;              ///< v [m/s], >= 0
  double flexural_strength = 0.0;  ///< sigma_f [Pa], > 0
  double ice_density = 900.0;      ///< rho_i [kg/m3]
  double water_density = 1025.0;   ///< rho_w [kg/m3]
  /// C_B [-], a coefficient of the regression. The quoted 37.4 kg/m3 is C_B (rho_w - rho_i) at a difference of 75
  /// kg/m3.
  double buoyancy_factor = 0.499;
  double gravity = kGravity;  ///< g [m/s2]
};

/// Mean resistance [N] and its parts.
struct JeongLoad {
  double total = 0.0;
  double buoyancy = 0.0;  ///< of the ice under the hull
  double clearing = 0.0;  ///< of the broken ice
  double breaking = 0.0;
};

/// Mean resistance of a ship in level ice, a regression of basin tests with a standard icebreaker:
///
///   R = C_B (rho_w - rho_i) g h B T + 1.11 F_h^-1.157 rho_i B h v^2 + 2.73 S_N^-1.54 rho_i B h v^2
///   F_h = v/sqrt(g h),   S_N = v/sqrt(sigma_f h/(rho_i B))              docs/theory/standards.md, (L7)
///
/// Neither the bow's angles nor the friction are inputs: the hull of the tests has one of each.
///
/// @see S.-Y. Jeong, C.-J. Lee, S.-R. Cho, Ice resistance prediction for standard icebreaker model ship, ISOPE 2010, as
/// quoted by J. Hu, L. Zhou, Int. J. Nav. Archit. Ocean Eng. 8 (2016) 169.
JeongLoad jeong(const JeongInput& input);

}  // namespace brash::standards
