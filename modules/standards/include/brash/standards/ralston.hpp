// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tl/expected.hpp>

#include "brash/core/constants.hpp"
#include "brash/standards/applicability.hpp"

namespace brash::standards {

/// Yield criterion of the plastic plate; one is used throughout.
enum class Yield {
  kTresca,    ///< Y = 2.711
  kJohansen,  ///< Y = 3.422
};

enum class Breaking { kUpward, kDownward };

/// Input of Ralston's plastic method for cones. SI, radians.
struct RalstonInput {
  double slope = 0.0;               ///< alpha, from the horizontal [rad], in (0, pi/2)
  double waterline_width = 0.0;     ///< w, diameter at the waterline [m], > 0
  double end_width = 0.0;           ///< w_T, diameter at the end of the slope where the ice rides to [m], in [0, w]
  double thickness = 0.0;           ///< h [m], > 0
  double ride_thickness = 0.0;      ///< h_r, of the layer of broken ice on the cone [m]; 0 means h
  double flexural_strength = 0.0;   ///< sigma_f [Pa], > 0
  double friction_structure = 0.0;  ///< mu [-]
  double ice_density = 900.0;       ///< rho_i [kg/m3]
  double water_density = 1025.0;    ///< rho_w [kg/m3]
  Breaking breaking = Breaking::kUpward;
  Yield yield = Yield::kTresca;
  double gravity = kGravity;  ///< g [m/s2]
};

/// Peak loads [N].
struct RalstonLoad {
  double radius_ratio = 0.0;         ///< x, radius of the circumferential crack over the waterline radius [-]
  double breaking_horizontal = 0.0;  ///< H_B
  double ride_horizontal = 0.0;      ///< H_R
  double breaking_vertical = 0.0;    ///< V_B
  double ride_vertical = 0.0;        ///< V_R
  double horizontal = 0.0;           ///< H_B + H_R
  double vertical = 0.0;             ///< V_B + V_R, magnitude
};

/// Loads of level ice on a cone by plastic limit analysis.
///
///   g_r = (sin a + a/cos a)/(pi/2 sin^2 a + 2 mu a cos a)
///   G   = rho g w^2/(4 sigma_f h),   x = 1 + (3 G + Y/2)^(-1/2)
///   H_B = (sigma_f h^2/3) tan a/(1 - mu g_r) [(1 + Y x ln x)/(x - 1) + G (x - 1)(x + 2)]
///   W   = rho g h_r (w^2 - w_T^2)/(4 cos a)
///   H_R = W [tan a + mu E2 - mu f g_r cos a]/(1 - mu g_r),   f = sin a + mu E1 cos a
///   h_v = (f cos a - mu E2)/(pi/4 sin^2 a + mu a cos a)
///   V_B = H_B h_v,   V_R = W cos a (pi/2 cos a - mu a - f h_v) + H_R h_v
///
/// E1, E2 are the complete elliptic integrals of the first and second kind with parameter m = sin^2 a; rho is rho_i for
/// upward breaking and the submerged weight's rho_w - rho_i for downward breaking. The coefficients A1 to A4 in
/// circulation mix two yield criteria; here Y is the same criterion in x and in H_B.
///
/// Applies to cones in thick ice at low speed with the ice layer on the whole slope; it gives an upper bound of the
/// peak. Outside: friction that locks the ice on the slope (mu g_r >= 1).
///
/// @see T. D. Ralston, Ice force design considerations for conical offshore structures, POAC 1977; ISO 19906,
/// A.8.2.4.4; docs/theory/standards.md, (L3).
tl::expected<RalstonLoad, NotApplicable> ralston(const RalstonInput& input);

}  // namespace brash::standards
