// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/hydrodynamics/structure_flow.hpp"

#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"

namespace brash::hydrodynamics {
namespace {

/// Where q^2 and e = R^2 - H^2 of the integral below differ by so much, its closed forms cancel to 1e-9 and the
/// sphere's series is as good.
constexpr double kNearlySphere = 1e-3;

/// The integral of ds / ((R^2 + s)^2 sqrt(H^2 + s)) from lambda on, with q^2 = H^2 + lambda and e = R^2 - H^2. It
/// equals the integral of 2 dq / (q^2 + e)^2 from q on.
double alpha(double q, double e) {
  const double ratio = e / (q * q);
  if (std::abs(ratio) < kNearlySphere) return (2.0 / 3.0 - ratio * (0.8 - ratio * 6.0 / 7.0)) / (q * q * q);
  const double root = std::sqrt(std::abs(e));
  const double angle = e > 0.0 ? std::atan(root / q) : std::atanh(root / q);
  return (angle / root - q / (q * q + e)) / e;
}

}  // namespace

StructureFlow::StructureFlow(double radius, double volume)
    : radius_(radius), depth_(1.5 * volume / (kPi * radius * radius)) {
  BRASH_EXPECTS(radius > 0.0 && volume > 0.0, radius, volume);
  const double size = radius_ * radius_ * depth_;
  strength_ = size / (2.0 - size * alpha(depth_, radius_ * radius_ - depth_ * depth_));
}

Vec3 StructureFlow::at(Vec3 point, Vec2 velocity) const {
  const Vec3 U{velocity.x, velocity.y, 0.0};
  const double RR = radius_ * radius_, HH = depth_ * depth_;
  const double across = point.x * point.x + point.y * point.y, up = point.z * point.z;
  // The confocal spheroid through the point: the larger root of across / (RR + l) + up / (HH + l) = 1.
  const double half = 0.5 * (across + up - RR - HH);
  const double lambda = half + std::sqrt(half * half + across * HH + up * RR - RR * HH);
  if (!(lambda > 0.0)) return U;

  const double a = RR + lambda, c = HH + lambda;
  const Vec3 normal{point.x / a, point.y / a, point.z / c};  // half the gradient of that spheroid's equation
  const Vec3 slope = 2.0 / dot(normal, normal) * normal;     // gradient of lambda
  const double alpha_slope = -1.0 / (a * a * std::sqrt(c));
  return -strength_ * (alpha(std::sqrt(c), RR - HH) * U + dot(U, point) * alpha_slope * slope);
}

}  // namespace brash::hydrodynamics
