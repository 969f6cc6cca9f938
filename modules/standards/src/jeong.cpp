// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/standards/jeong.hpp"

#include <cmath>

#include "brash/core/contract.hpp"

namespace brash::standards {

JeongLoad jeong(const JeongInput& in) {
  BRASH_EXPECTS(in.breadth > 0.0 && in.draught > 0.0 && in.thickness > 0.0, in.breadth, in.draught, in.thickness);
  BRASH_EXPECTS(in.speed >= 0.0 && in.flexural_strength > 0.0, in.speed, in.flexural_strength);
  BRASH_EXPECTS(in.ice_density > 0.0 && in.water_density > in.ice_density, in.ice_density, in.water_density);
  BRASH_EXPECTS(in.buoyancy_factor > 0.0 && in.gravity > 0.0, in.buoyancy_factor, in.gravity);
  const double B = in.breadth, h = in.thickness, v = in.speed;
  JeongLoad load;
  load.buoyancy = in.buoyancy_factor * (in.water_density - in.ice_density) * in.gravity * h * B * in.draught;
  if (v > 0.0) {  // both powers of v are positive in all, but not in each factor
    const double inertia = in.ice_density * B * h * v * v;
    const double froude = v / std::sqrt(in.gravity * h);
    const double strength = v / std::sqrt(in.flexural_strength * h / (in.ice_density * B));
    load.clearing = 1.11 * std::pow(froude, -1.157) * inertia;
    load.breaking = 2.73 * std::pow(strength, -1.54) * inertia;
  }
  load.total = load.buoyancy + load.clearing + load.breaking;
  return load;
}

}  // namespace brash::standards
