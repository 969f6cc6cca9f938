// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tl/expected.hpp>

#include "brash/core/constants.hpp"
#include "brash/standards/applicability.hpp"

namespace brash::standards {

/// A ship's hull in level ice. SI, radians.
struct LindqvistInput {
  double length = 0.0;             ///< L, at the waterline [m], > 0
  double breadth = 0.0;            ///< B [m], > 0
  double draught = 0.0;            ///< T [m], > 0
  double stem_angle = 0.0;         ///< phi, of the stem from the horizontal [rad], in (0, pi/2)
  double waterline_angle = 0.0;    ///< alpha, waterline's entrance from the centre line [rad], in (0, pi/2]
  double speed = 0.0;              ///< v [m/s], >= 0
  double thickness = 0.0;          ///< h, of the ice [m], > 0
  double flexural_strength = 0.0;  ///< sigma_b [Pa], > 0
  double youngs_modulus = 0.0;     ///< E [Pa], > 0
  double poisson_ratio = 0.3;      ///< nu [-]
  double friction = 0.0;           ///< mu, hull on ice [-]
  double ice_density = 900.0;      ///< rho_i [kg/m3]
  double water_density = 1025.0;   ///< rho_w [kg/m3]
  double gravity = kGravity;       ///< g [m/s2]
};

/// Mean resistance [N] and its parts at zero speed.
struct LindqvistLoad {
  double crushing = 0.0;    ///< R_c, at the stem
  double bending = 0.0;     ///< R_b
  double submersion = 0.0;  ///< R_s
  double total = 0.0;       ///< R at speed v
};

/// Mean resistance of a ship in level ice.
///
///   psi = atan(tan phi/sin alpha)
///   R_c = 0.5 sigma_b h^2 (tan phi + mu cos phi/cos psi)/(1 - mu sin phi/cos psi)
///   R_b = (27/64) sigma_b B h^1.5 / sqrt(E/(12 (1-nu^2) g rho_w))
///         (tan psi + mu cos phi/(sin alpha cos psi)) (1 + 1/cos psi)
///   R_s = (rho_w - rho_i) g h B { T (B+T)/(B+2T)
///         + mu [0.7 L - T/tan phi - B/(4 tan alpha) + T cos phi cos psi sqrt(1/sin^2 phi + 1/tan^2 alpha)] }
///   R   = (R_c + R_b)(1 + 1.4 v/sqrt(g h)) + R_s (1 + 9.4 v/sqrt(g L))
///
/// Others write 0.003 for 27/64 over the root, which is its value at E = 2 GPa (Hu and Zhou 2016), or 37/64 (a public
/// program after Fan, Yu and Jiang 2019), with which R_b is 37 % larger.
///
/// Applies to conventional icebreaking bows in continuous motion. Outside: a bow on which friction locks the ice
/// (mu sin phi >= cos psi).
///
/// @see G. Lindqvist, A straightforward method for calculation of ice resistance of ships, POAC 1989.
tl::expected<LindqvistLoad, NotApplicable> lindqvist(const LindqvistInput& input);

}  // namespace brash::standards
