// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/standards/ridge.hpp"

#include <cmath>

#include "brash/core/contract.hpp"
#include "brash/standards/crushing.hpp"

namespace brash::standards {

KeelLoad keel(const KeelInput& in) {
  BRASH_EXPECTS(in.width > 0.0 && in.keel_depth > 0.0, in.width, in.keel_depth);
  BRASH_EXPECTS(in.keel_porosity >= 0.0 && in.keel_porosity < 1.0, in.keel_porosity);
  BRASH_EXPECTS(in.keel_cohesion >= 0.0, in.keel_cohesion);
  BRASH_EXPECTS(in.keel_friction_angle >= 0.0 && in.keel_friction_angle < 0.5 * kPi, in.keel_friction_angle);
  BRASH_EXPECTS(in.ice_density > 0.0 && in.water_density > in.ice_density, in.ice_density, in.water_density);
  const double w = in.width, h_k = in.keel_depth;
  const double mu = std::tan(0.25 * kPi + 0.5 * in.keel_friction_angle);
  const double gamma = (1.0 - in.keel_porosity) * (in.water_density - in.ice_density) * in.gravity;
  const double per_pressure = mu * h_k * w * (1.0 + h_k / (6.0 * w));
  KeelLoad load;
  load.buoyancy = per_pressure * 0.5 * h_k * mu * gamma;
  load.cohesion = per_pressure * 2.0 * in.keel_cohesion;
  load.horizontal = load.buoyancy + load.cohesion;
  return load;
}

tl::expected<RidgeLoad, NotApplicable> ridge(const RidgeInput& in) {
  const KeelLoad below = keel({.width = in.width,
                               .keel_depth = in.keel_depth,
                               .keel_porosity = in.keel_porosity,
                               .keel_cohesion = in.keel_cohesion,
                               .keel_friction_angle = in.keel_friction_angle,
                               .ice_density = in.ice_density,
                               .water_density = in.water_density,
                               .gravity = in.gravity});
  const auto layer = global_crushing(
      {.width = in.width, .thickness = in.layer_thickness, .strength_coefficient = in.strength_coefficient});
  if (!layer) return tl::unexpected(layer.error());
  return RidgeLoad{.horizontal = layer->horizontal + below.horizontal,
                   .layer = layer->horizontal,
                   .layer_pressure = layer->pressure,
                   .keel = below.horizontal};
}

}  // namespace brash::standards
