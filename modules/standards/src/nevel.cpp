// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/standards/nevel.hpp"

#include <cmath>

#include "brash/core/contract.hpp"

namespace brash::standards {

NevelLoad nevel(const NevelInput& in) {
  BRASH_EXPECTS(in.wedge_angle > 0.0 && in.wedge_angle < kPi, in.wedge_angle);
  BRASH_EXPECTS(in.loaded_length >= 0.0, in.loaded_length);
  BRASH_EXPECTS(in.thickness > 0.0 && in.flexural_strength > 0.0 && in.youngs_modulus > 0.0);
  BRASH_EXPECTS(in.water_density > 0.0 && in.gravity > 0.0);
  const double h = in.thickness;
  NevelLoad load;
  load.characteristic_length = std::pow(in.youngs_modulus * h * h * h / (12.0 * in.water_density * in.gravity), 0.25);
  const double a_l = in.loaded_length / load.characteristic_length;
  const double b_0 = 2.0 * std::tan(0.5 * in.wedge_angle);
  load.vertical = b_0 * in.flexural_strength * h * h / 6.0 * (1.05 + 2.0 * a_l + 0.50 * a_l * a_l * a_l);
  load.in_range = a_l <= 0.6;
  return load;
}

}  // namespace brash::standards
