// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/core/constants.hpp"

namespace brash::standards {

/// A narrow wedge of floating ice, loaded at its tip. SI, radians.
struct NevelInput {
  double wedge_angle = 0.0;        ///< opening angle [rad], in (0, pi); b_0 = 2 tan(angle/2)
  double loaded_length = 0.0;      ///< a, from the tip, under uniform pressure [m], >= 0
  double thickness = 0.0;          ///< h [m], > 0
  double flexural_strength = 0.0;  ///< sigma [Pa], > 0
  double youngs_modulus = 0.0;     ///< E [Pa], > 0
  double water_density = 1025.0;   ///< rho_w [kg/m3]
  double gravity = kGravity;       ///< g [m/s2]
};

struct NevelLoad {
  double characteristic_length = 0.0;  ///< l = (E h^3/(12 rho_w g))^(1/4) of the beam [m]
  double vertical = 0.0;               ///< P, force that breaks the wedge [N]
  bool in_range = false;               ///< a/l at most 0.6, where the formula errs by about 1 %
};

/// Vertical force that breaks a narrow wedge, loaded by uniform pressure over the length a at its tip.
///
///   P = (b_0 sigma h^2/6) [1.05 + 2.0 (a/l) + 0.50 (a/l)^3]      docs/theory/standards.md, (L4)
///
/// Narrow: the wedge bends as a beam whose width b_0 r grows with the distance r from the tip. Against the exact
/// solution of that beam the formula errs by at most 1.2 % for 0.02 <= a/l <= 0.6 and is 4 % low at 1, 11 % low at 1.5.
///
/// @see D. E. Nevel, The ultimate failure of a floating ice sheet, IAHR 1972; paper, refs. 37, 38.
NevelLoad nevel(const NevelInput& input);

}  // namespace brash::standards
