// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/standards/riska.hpp"

#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"

namespace brash::standards {

RiskaLoad riska(const RiskaInput& in) {
  BRASH_EXPECTS(in.length > 0.0 && in.breadth > 0.0 && in.draught > 0.0, in.length, in.breadth, in.draught);
  BRASH_EXPECTS(in.midbody >= 0.0 && in.bow_length > 0.0, in.midbody, in.bow_length);
  BRASH_EXPECTS(in.stem_angle > 0.0 && in.stem_angle <= 0.5 * kPi, in.stem_angle);
  BRASH_EXPECTS(in.speed >= 0.0 && in.thickness > 0.0, in.speed, in.thickness);
  const double L = in.length, B = in.breadth, T = in.draught, h = in.thickness;
  const double phi = degrees(in.stem_angle);  // the regression takes degrees and gives kN
  constexpr double kKilonewton = 1e3;
  RiskaLoad load;
  load.at_rest = kKilonewton * (0.23 * B * in.midbody * h / (2.0 * T / B + 1.0) +
                                (1.0 + 0.021 * phi) *
                                    (4.58 * B * h * h + 1.47 * in.bow_length * h * h + 0.29 * B * in.bow_length * h));
  load.per_speed = kKilonewton * ((1.0 + 0.063 * phi) * (18.9 * std::pow(h, 1.5) + 0.67 * B * h) +
                                  1.55 * h * (1.0 + 1.2 * T / B) * B * B / std::sqrt(L));
  load.total = load.at_rest + load.per_speed * in.speed;
  return load;
}

}  // namespace brash::standards
