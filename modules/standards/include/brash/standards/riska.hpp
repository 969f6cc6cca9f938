// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace brash::standards {

/// A ship's hull in level ice. SI, radians.
struct RiskaInput {
  double length = 0.0;      ///< L, at the waterline [m], > 0
  double breadth = 0.0;     ///< B [m], > 0
  double draught = 0.0;     ///< T [m], > 0
  double midbody = 0.0;     ///< L_par, length of the waterline's parallel part [m], >= 0
  double bow_length = 0.0;  ///< L_bow, of the waterline from the stem to the parallel part [m], > 0
  double stem_angle = 0.0;  ///< phi, of the stem from the horizontal [rad], in (0, pi/2]
  double thickness = 0.0;   ///< h, of the ice [m], > 0
  double speed = 0.0;       ///< v [m/s], >= 0
};

/// Mean resistance.
struct RiskaLoad {
  double total = 0.0;      ///< R = C1 + C2 v [N]
  double at_rest = 0.0;    ///< C1 [N]
  double per_speed = 0.0;  ///< C2 [N s/m]
};

/// Mean resistance of a ship in level ice, a regression of full-scale tests in the Baltic; phi in degrees, R in kN:
///
///   C1 = f1 B L_par h/(2 T/B + 1) + (1 + 0.021 phi)(f2 B h^2 + f3 L_bow h^2 + f4 B L_bow h)
///   C2 = (1 + 0.063 phi)(g1 h^1.5 + g2 B h) + g3 h (1 + 1.2 T/B) B^2/sqrt(L)
///   R  = C1 + C2 v                                                     docs/theory/standards.md, (L6)
///
///   f1 = 0.23 kN/m3, f2 = 4.58 kN/m3, f3 = 1.47 kN/m3, f4 = 0.29 kN/m3
///   g1 = 18.9 kN/(m/s m^1.5), g2 = 0.67 kN/(m/s m^2), g3 = 1.55 kN/(m/s m^2.5)
///
/// Strength and friction are the values of Baltic ice and ships; they are not inputs.
///
/// @see K. Riska, M. Wilhelmson, K. Englund, T. Leiviska, Performance of merchant vessels in ice in the Baltic,
/// Helsinki University of Technology, 1997, as quoted by J. Hu, L. Zhou, Int. J. Nav. Archit. Ocean Eng. 8 (2016) 169.
/// The Finnish-Swedish ice class rules have the same coefficients for h = 0.1 m and v = 5 kn.
RiskaLoad riska(const RiskaInput& input);

}  // namespace brash::standards
