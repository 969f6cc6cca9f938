// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tl/expected.hpp>

#include "brash/core/constants.hpp"
#include "brash/standards/applicability.hpp"

namespace brash::standards {

/// Input of the elastic-beam method of ISO 19906. SI, radians.
struct CroasdaleInput {
  double slope = 0.0;               ///< alpha, structure's slope from the horizontal [rad], in (0, pi/2)
  double width = 0.0;               ///< w, of the structure at the waterline [m], > 0
  double thickness = 0.0;           ///< h [m], > 0
  double flexural_strength = 0.0;   ///< sigma_f [Pa], > 0
  double youngs_modulus = 0.0;      ///< E [Pa], > 0
  double poisson_ratio = 0.3;       ///< nu [-]
  double friction_structure = 0.0;  ///< mu, ice on structure [-]
  double friction_ice = 0.0;        ///< mu_i, ice on ice [-]
  double ice_density = 900.0;       ///< rho_i [kg/m3]
  double water_density = 1025.0;    ///< rho_w [kg/m3]
  /// Effective density of ice that is lifted or pushed under [kg/m3]: rho_i for upward breaking, rho_w - rho_i for
  /// downward breaking; 0 means rho_i.
  double weight_density = 0.0;
  double rubble_height = 0.0;                    ///< h_r, of the rubble on the slope [m]; 0: no rubble
  double rubble_porosity = 0.3;                  ///< e [-]
  double rubble_cohesion = 0.0;                  ///< c [Pa]
  double rubble_angle = radians(40.0);           ///< theta, slope of the rubble's surface [rad], < alpha
  double rubble_friction_angle = radians(45.0);  ///< phi, inside the rubble [rad]
  double gravity = kGravity;                     ///< g [m/s2]
};

/// Peak loads of one breaking event [N], horizontal unless stated.
struct CroasdaleLoad {
  double characteristic_length = 0.0;  ///< L_c of the plate [m]
  double force_ratio = 0.0;            ///< xi = F_H / F_V [-]
  double crack_length = 0.0;           ///< l = w + (pi^2/4) L_c, length of the circumferential crack [m]
  double breaking = 0.0;               ///< H_B, bending failure
  double pushing = 0.0;                ///< H_P, pushing the sheet through the rubble
  double ride_up = 0.0;                ///< H_R, pushing blocks up the slope through the rubble
  double lifting = 0.0;                ///< H_L, lifting and shearing the rubble on the sheet
  double turning = 0.0;                ///< H_T, turning the blocks at the top of the slope
  double in_plane_factor = 0.0;        ///< 1 / (1 - H_B / (sigma_f l h)), effect of the in-plane compression [-]
  double horizontal = 0.0;             ///< F_H
  double vertical = 0.0;  ///< F_V, magnitude: down on the ice of a downward-breaking slope, up on the other
};

/// Loads of level ice on a sloping structure by the elastic-beam method.
///
///   xi  = (sin a + mu cos a)/(cos a - mu sin a),   l = w + (pi^2/4) L_c
///   H_B = 0.68 xi sigma_f (rho_w g h^5/E)^(1/4) l
///   H_P = w h_r^2 mu_i rho g (1-e) t^2 / (2 tan th),   t = 1 - tan th/tan a
///   H_R = w P/(cos a - mu sin a)
///   P   = mu_i (mu_i + mu) q h_r sin a (cot th - cot a) t + (mu_i + mu) q h_r (cos a/tan a) t
///         + h_r h rho g (sin a + mu cos a)/sin a,    q = rho g (1-e) h_r/2
///   H_L = w q h_r xi t [(cot th - cot a) + t tan phi] + xi c w h_r t
///   H_T = 1.5 w h^2 rho g cos a/(sin a - mu cos a)
///   F_H = (H_B + H_P + H_R + H_L + H_T)/(1 - H_B/(sigma_f l h)),   F_V = F_H/xi
///
/// Applies to wide sloping structures, w well above L_c, at low speed; it gives the peak of one breaking event, not a
/// mean. Outside: a slope at which friction locks the ice (tan a >= 1/mu or tan a <= mu), rubble as steep as the
/// structure, ice that crushes before it bends (H_B >= sigma_f l h).
///
/// @see ISO 19906, A.8.2.4.4; K. R. Croasdale, A. B. Cammaert, M. Metge, 1994; docs/theory/standards.md, (L1), (L2).
tl::expected<CroasdaleLoad, NotApplicable> croasdale(const CroasdaleInput& input);

}  // namespace brash::standards
