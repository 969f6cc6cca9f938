// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/standards/lengths.hpp"

#include <cmath>
#include <numbers>

#include "brash/core/contract.hpp"

namespace brash::standards {

double characteristic_length(const PlateInput& in) {
  BRASH_EXPECTS(in.thickness > 0.0 && in.youngs_modulus > 0.0, in.thickness, in.youngs_modulus);
  BRASH_EXPECTS(in.poisson_ratio >= 0.0 && in.poisson_ratio < 1.0, in.poisson_ratio);
  BRASH_EXPECTS(in.water_density > 0.0 && in.gravity > 0.0, in.water_density, in.gravity);
  const double h = in.thickness, k = in.water_density * in.gravity;
  const double D = in.youngs_modulus * h * h * h / (12.0 * (1.0 - in.poisson_ratio * in.poisson_ratio));
  return std::pow(D / k, 0.25);
}

double breaking_length(const PlateInput& in) { return 0.25 * kPi * std::numbers::sqrt2 * characteristic_length(in); }

}  // namespace brash::standards
