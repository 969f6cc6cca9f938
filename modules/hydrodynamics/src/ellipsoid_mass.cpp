// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/hydrodynamics/ellipsoid_mass.hpp"

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "elliptic.hpp"

namespace brash::hydrodynamics {
namespace {

/// Two axes that are nearer than this have a round section, which turns without the water [-].
constexpr double kRound = 1e-6;

/// Of a turn about the axis across b and c, over the displaced volume [m2]; squares of the semi-axes and their
/// integrals.
double about(double b2, double c2, double beta, double gamma) {
  const double apart = b2 - c2;
  if (std::abs(apart) <= kRound * (b2 + c2)) return 0.0;
  return 0.2 * apart * apart * (gamma - beta) / (2.0 * apart + (b2 + c2) * (beta - gamma));
}

}  // namespace

EntrainedWater entrained_by_half(Vec3 a) {
  BRASH_EXPECTS(a.x > 0.0 && a.y > 0.0 && a.z > 0.0, a.x, a.y, a.z);
  const Vec3 s{a.x * a.x, a.y * a.y, a.z * a.z};
  const double product = a.x * a.y * a.z, volume = 2.0 / 3.0 * kPi * product;
  // Shares of the three directions; they add up to 2.
  const double alpha = product * 2.0 / 3.0 * elliptic_rd(s.y, s.z, s.x);
  const double beta = product * 2.0 / 3.0 * elliptic_rd(s.z, s.x, s.y);
  const double gamma = product * 2.0 / 3.0 * elliptic_rd(s.x, s.y, s.z);
  return {volume * Vec3{alpha / (2.0 - alpha), beta / (2.0 - beta), gamma / (2.0 - gamma)},
          volume * Vec3{about(s.y, s.z, beta, gamma), about(s.z, s.x, gamma, alpha), about(s.x, s.y, alpha, beta)}};
}

}  // namespace brash::hydrodynamics
