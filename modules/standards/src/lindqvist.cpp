// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/standards/lindqvist.hpp"

#include <cmath>

#include "brash/core/contract.hpp"

namespace brash::standards {
namespace {

void check(const LindqvistInput& in) {
  BRASH_EXPECTS(in.length > 0.0 && in.breadth > 0.0 && in.draught > 0.0, in.length, in.breadth, in.draught);
  BRASH_EXPECTS(in.stem_angle > 0.0 && in.stem_angle < 0.5 * kPi, in.stem_angle);
  BRASH_EXPECTS(in.waterline_angle > 0.0 && in.waterline_angle <= 0.5 * kPi, in.waterline_angle);
  BRASH_EXPECTS(in.speed >= 0.0 && in.thickness > 0.0, in.speed, in.thickness);
  BRASH_EXPECTS(in.flexural_strength > 0.0 && in.youngs_modulus > 0.0);
  BRASH_EXPECTS(in.poisson_ratio >= 0.0 && in.poisson_ratio < 1.0, in.poisson_ratio);
  BRASH_EXPECTS(in.friction >= 0.0, in.friction);
  BRASH_EXPECTS(in.ice_density > 0.0 && in.water_density > in.ice_density, in.ice_density, in.water_density);
}

/// R_s; psi is the angle of the hull's normal.
double submersion(const LindqvistInput& in, double psi) {
  const double phi = in.stem_angle, alpha = in.waterline_angle, B = in.breadth, T = in.draught;
  const double potential = T * (B + T) / (B + 2.0 * T);
  const double slant = std::sqrt(1.0 / std::pow(std::sin(phi), 2) + 1.0 / std::pow(std::tan(alpha), 2));
  const double friction_length =
      0.7 * in.length - T / std::tan(phi) - B / (4.0 * std::tan(alpha)) + T * std::cos(phi) * std::cos(psi) * slant;
  return (in.water_density - in.ice_density) * in.gravity * in.thickness * B *
         (potential + in.friction * friction_length);
}

}  // namespace

tl::expected<LindqvistLoad, NotApplicable> lindqvist(const LindqvistInput& in) {
  check(in);
  const double phi = in.stem_angle, alpha = in.waterline_angle, mu = in.friction, h = in.thickness;
  const double psi = std::atan(std::tan(phi) / std::sin(alpha));
  const double slip = 1.0 - mu * std::sin(phi) / std::cos(psi);
  if (slip <= 0.0)
    return tl::unexpected(NotApplicable{"friction locks the ice under the bow: mu sin(phi) >= cos(psi)"});

  LindqvistLoad load;
  load.crushing = 0.5 * in.flexural_strength * h * h * (std::tan(phi) + mu * std::cos(phi) / std::cos(psi)) / slip;
  const double stiffness =
      in.youngs_modulus / (12.0 * (1.0 - in.poisson_ratio * in.poisson_ratio) * in.gravity * in.water_density);
  load.bending = 27.0 / 64.0 * in.flexural_strength * in.breadth * std::pow(h, 1.5) / std::sqrt(stiffness) *
                 (std::tan(psi) + mu * std::cos(phi) / (std::sin(alpha) * std::cos(psi))) * (1.0 + 1.0 / std::cos(psi));
  load.submersion = submersion(in, psi);
  load.total = (load.crushing + load.bending) * (1.0 + 1.4 * in.speed / std::sqrt(in.gravity * h)) +
               load.submersion * (1.0 + 9.4 * in.speed / std::sqrt(in.gravity * in.length));
  return load;
}

}  // namespace brash::standards
