// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tl/expected.hpp>

#include "brash/core/constants.hpp"
#include "brash/standards/applicability.hpp"

namespace brash::standards {

/// The rubble of a first-year ridge's keel against a vertical face. SI, radians.
struct KeelInput {
  double width = 0.0;                ///< w, of the structure [m], > 0
  double keel_depth = 0.0;           ///< h_k, of the rubble below the consolidated layer [m], > 0
  double keel_porosity = 0.0;        ///< e [-], in [0, 1)
  double keel_cohesion = 0.0;        ///< c, mean over the keel [Pa], >= 0
  double keel_friction_angle = 0.0;  ///< phi, inside the rubble [rad], in [0, pi/2)
  double ice_density = 900.0;        ///< rho_i [kg/m3]
  double water_density = 1025.0;     ///< rho_w [kg/m3]
  double gravity = kGravity;         ///< g [m/s2]
};

struct KeelLoad {
  double horizontal = 0.0;  ///< F_k [N]
  double buoyancy = 0.0;    ///< its part of friction under the rubble's buoyancy [N]
  double cohesion = 0.0;    ///< its part of cohesion [N]
};

/// Load of a keel that fails as soil against a wall (passive failure):
///
///   F_k = mu h_k w (h_k mu gamma/2 + 2 c)(1 + h_k/(6 w))                docs/theory/standards.md, (L8)
///   mu  = tan(pi/4 + phi/2),   gamma = (1 - e)(rho_w - rho_i) g
///
/// mu^2 is Rankine's coefficient of passive earth pressure; the last factor is for the rubble beside a narrow
/// structure. Rubble that piles up before the structure is left out.
///
/// @see Y. V. Dolgopolov, V. P. Afanasiev, V. A. Korenkov, D. F. Panfilov, Effect of hummocked ice on piers of marine
/// hydraulic structures, IAHR Ice Symposium, Hanover 1975; ISO 19906, A.8.2.4.5.
KeelLoad keel(const KeelInput& input);

/// A first-year ridge against a vertical face. SI, radians.
struct RidgeInput {
  double width = 0.0;                 ///< w, of the structure [m], > 0
  double layer_thickness = 0.0;       ///< h_c, of the consolidated layer [m], > 0
  double strength_coefficient = 0.0;  ///< C_R [Pa]: 2.8 MPa in the Arctic, 1.8 MPa in the Baltic
  double keel_depth = 0.0;            ///< as KeelInput
  double keel_porosity = 0.0;
  double keel_cohesion = 0.0;
  double keel_friction_angle = 0.0;
  double ice_density = 900.0;
  double water_density = 1025.0;
  double gravity = kGravity;
};

struct RidgeLoad {
  double horizontal = 0.0;      ///< F_c + F_k [N]
  double layer = 0.0;           ///< F_c, crushing of the consolidated layer [N]
  double layer_pressure = 0.0;  ///< p [Pa], of the crushing
  double keel = 0.0;            ///< F_k [N]
};

/// Load of a first-year ridge on a vertical face: the consolidated layer crushes as level ice of its thickness (L5),
/// and the keel fails below it (L8). Both act at once, and the sail is left out.
///
/// @returns NotApplicable as global_crushing().
/// @see ISO 19906, A.8.2.4.5.
tl::expected<RidgeLoad, NotApplicable> ridge(const RidgeInput& input);

}  // namespace brash::standards
