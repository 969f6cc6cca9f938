// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/standards/croasdale.hpp"

#include <cmath>

#include "brash/core/contract.hpp"
#include "brash/standards/lengths.hpp"

namespace brash::standards {
namespace {

void check(const CroasdaleInput& in) {
  BRASH_EXPECTS(in.slope > 0.0 && in.slope < 0.5 * kPi, in.slope);
  BRASH_EXPECTS(in.width > 0.0 && in.thickness > 0.0, in.width, in.thickness);
  BRASH_EXPECTS(in.flexural_strength > 0.0 && in.youngs_modulus > 0.0, in.flexural_strength, in.youngs_modulus);
  BRASH_EXPECTS(in.poisson_ratio >= 0.0 && in.poisson_ratio < 1.0, in.poisson_ratio);
  BRASH_EXPECTS(in.friction_structure >= 0.0 && in.friction_ice >= 0.0, in.friction_structure, in.friction_ice);
  BRASH_EXPECTS(in.water_density > 0.0 && in.ice_density > 0.0 && in.weight_density >= 0.0);
  BRASH_EXPECTS(in.rubble_height >= 0.0, in.rubble_height);
  BRASH_EXPECTS(in.rubble_angle > 0.0 && in.rubble_angle < 0.5 * kPi, in.rubble_angle);
  BRASH_EXPECTS(in.rubble_porosity >= 0.0 && in.rubble_porosity < 1.0, in.rubble_porosity);
}

/// The rubble's share: H_P, H_R, H_L. Symbols as in the header.
void add_rubble(const CroasdaleInput& in, double rho, CroasdaleLoad& load) {
  const double a = in.slope, mu = in.friction_structure, mu_i = in.friction_ice, w = in.width, h_r = in.rubble_height;
  const double t = 1.0 - std::tan(in.rubble_angle) / std::tan(a);
  const double cot_difference = 1.0 / std::tan(in.rubble_angle) - 1.0 / std::tan(a);
  const double q = 0.5 * rho * in.gravity * (1.0 - in.rubble_porosity) * h_r;

  load.pushing = w * h_r * mu_i * q * t * t / std::tan(in.rubble_angle);
  const double P = mu_i * (mu_i + mu) * q * h_r * std::sin(a) * cot_difference * t +
                   (mu_i + mu) * q * h_r * std::cos(a) / std::tan(a) * t +
                   h_r * in.thickness * rho * in.gravity * (std::sin(a) + mu * std::cos(a)) / std::sin(a);
  load.ride_up = w * P / (std::cos(a) - mu * std::sin(a));
  load.lifting = w * q * h_r * load.force_ratio * t * (cot_difference + t * std::tan(in.rubble_friction_angle)) +
                 load.force_ratio * in.rubble_cohesion * w * h_r * t;
}

}  // namespace

tl::expected<CroasdaleLoad, NotApplicable> croasdale(const CroasdaleInput& in) {
  check(in);
  const double a = in.slope, mu = in.friction_structure, h = in.thickness;
  const double sine = std::sin(a), cosine = std::cos(a);
  if (cosine - mu * sine <= 0.0) return tl::unexpected(NotApplicable{"the ice locks: tan(slope) >= 1/friction"});
  if (sine - mu * cosine <= 0.0) return tl::unexpected(NotApplicable{"the ice does not slide: tan(slope) <= friction"});
  if (in.rubble_height > 0.0 && in.rubble_angle >= a) {
    return tl::unexpected(NotApplicable{"the rubble is as steep as the structure"});
  }

  const double rho = in.weight_density > 0.0 ? in.weight_density : in.ice_density;
  const double k = in.water_density * in.gravity;
  CroasdaleLoad load;
  load.characteristic_length = characteristic_length({.thickness = h,
                                                      .youngs_modulus = in.youngs_modulus,
                                                      .poisson_ratio = in.poisson_ratio,
                                                      .water_density = in.water_density,
                                                      .gravity = in.gravity});
  load.force_ratio = (sine + mu * cosine) / (cosine - mu * sine);
  load.crack_length = in.width + 0.25 * kPi * kPi * load.characteristic_length;
  load.breaking = 0.68 * load.force_ratio * in.flexural_strength *
                  std::pow(k * std::pow(h, 5) / in.youngs_modulus, 0.25) * load.crack_length;
  if (in.rubble_height > 0.0) add_rubble(in, rho, load);
  load.turning = 1.5 * in.width * h * h * rho * in.gravity * cosine / (sine - mu * cosine);

  const double compression = load.breaking / (in.flexural_strength * load.crack_length * h);
  if (compression >= 1.0)
    return tl::unexpected(NotApplicable{"the in-plane compression exceeds the flexural strength"});
  load.in_plane_factor = 1.0 / (1.0 - compression);
  load.horizontal = (load.breaking + load.pushing + load.ride_up + load.lifting + load.turning) * load.in_plane_factor;
  load.vertical = load.horizontal / load.force_ratio;
  return load;
}

}  // namespace brash::standards
