// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/hydrodynamics/structure_flow.hpp"

#include <algorithm>
#include <cmath>

#include "brash/core/contract.hpp"
#include "elliptic.hpp"

namespace brash::hydrodynamics {
namespace {

/// The integrals of ds / ((a^2 + s) D(s)) and ds / ((b^2 + s) D(s)) from lambda on, D(s) the root of the product of all
/// (a^2 + s); by the squares a^2 + lambda [1/m3].
Vec2 alpha_and_beta(Vec3 s) { return {2.0 / 3.0 * elliptic_rd(s.y, s.z, s.x), 2.0 / 3.0 * elliptic_rd(s.z, s.x, s.y)}; }

/// The confocal ellipsoid through a point outside or on the surface: the largest root of sum x^2 / (a^2 + lambda) = 1
/// [m2]. The sum is convex, so Newton's steps from below rise to the root.
double confocal(Vec3 point, Vec3 squares) {
  const Vec3 p{point.x * point.x, point.y * point.y, point.z * point.z};
  double lambda = std::max(0.0, p.x + p.y + p.z - std::max({squares.x, squares.y, squares.z}));
  for (;;) {
    const Vec3 s = squares + Vec3{lambda, lambda, lambda};
    const Vec3 terms{p.x / s.x, p.y / s.y, p.z / s.z};
    const double beyond = terms.x + terms.y + terms.z - 1.0;
    const double next = lambda + beyond / (terms.x / s.x + terms.y / s.y + terms.z / s.z);
    if (!(next > lambda)) return lambda;
    lambda = next;
  }
}

}  // namespace

StructureFlow::StructureFlow(Vec3 semi_axes)
    : squares_{semi_axes.x * semi_axes.x, semi_axes.y * semi_axes.y, semi_axes.z * semi_axes.z} {
  BRASH_EXPECTS(semi_axes.x > 0.0 && semi_axes.y > 0.0 && semi_axes.z > 0.0, semi_axes.x, semi_axes.y, semi_axes.z);
  const double product = semi_axes.x * semi_axes.y * semi_axes.z;
  const Vec2 integrals = alpha_and_beta(squares_);
  strength_ = {product / (2.0 - product * integrals.x), product / (2.0 - product * integrals.y)};
}

Vec3 StructureFlow::at(Vec3 point, Vec2 velocity) const {
  const Vec3 p{point.x * point.x, point.y * point.y, point.z * point.z};
  const double inside = std::sqrt(p.x / squares_.x + p.y / squares_.y + p.z / squares_.z);  // 1 on the surface
  if (inside == 0.0) return {velocity.x, velocity.y, 0.0};
  if (inside < 1.0) point = point / inside;
  const double lambda = confocal(point, squares_);
  const Vec3 s = squares_ + Vec3{lambda, lambda, lambda};
  const Vec3 normal{point.x / s.x, point.y / s.y, point.z / s.z};  // half the gradient of that ellipsoid's equation
  const Vec3 slope = 2.0 / dot(normal, normal) * normal;           // gradient of lambda
  const Vec2 integrals = alpha_and_beta(s);
  const double root = std::sqrt(s.x * s.y * s.z);
  const Vec2 strong{strength_.x * velocity.x, strength_.y * velocity.y};
  const double along = strong.x * point.x / (s.x * root) + strong.y * point.y / (s.y * root);
  return along * slope - Vec3{strong.x * integrals.x, strong.y * integrals.y, 0.0};
}

Vec3 StructureFlow::acceleration(Vec3 point, Vec2 velocity) const {
  // A particle of water passes the ellipsoid at u - U. Central differences over 1e-4 of the size leave 1e-8 of it.
  const Vec3 past = at(point, velocity) - Vec3{velocity.x, velocity.y, 0.0};
  const double speed = norm(past);
  if (speed == 0.0) return {};
  const double time = 1e-4 * std::sqrt(std::max({squares_.x, squares_.y, squares_.z})) / speed;
  return (at(point + time * past, velocity) - at(point - time * past, velocity)) / (2.0 * time);
}

}  // namespace brash::hydrodynamics
