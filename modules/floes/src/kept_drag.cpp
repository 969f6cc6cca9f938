// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/floes/kept_drag.hpp"

#include <algorithm>
#include <cmath>

namespace brash::floes {
namespace {

/// Weight of travel across the reference velocity, relative to travel along it [-].
constexpr double kTurn = 10.0;

/// a . M b, both in the body frame [J].
double inner(const rigid_body::MassProperties& m, const Twist& a, const Twist& b) {
  const Vec3 v = a.angular, w = b.angular;
  return m.mass * dot(a.linear, b.linear) + m.added_across * a.linear.z * b.linear.z + m.inertia.x * v.x * w.x +
         m.inertia.y * v.y * w.y + m.inertia.z * v.z * w.z;
}

}  // namespace

std::optional<hydrodynamics::Drag> KeptDrag::follow(const rigid_body::MassProperties& mass, const Twist& now,
                                                    double dt) {
  if (left <= 0.0) return std::nullopt;
  const double square = inner(mass, now, now), square_then = inner(mass, velocity, velocity);
  if (square == 0.0) return hydrodynamics::Drag{};
  const double ratio = std::sqrt(square / square_then);
  if (!std::isfinite(ratio)) return std::nullopt;  // rest shows nothing of a motion
  const double off = std::max(0.0, 2.0 * (square - ratio * inner(mass, now, velocity)));
  left -= dt * (std::sqrt(square / mass.mass) + kTurn * std::sqrt(off / mass.mass));
  if (left <= 0.0) return std::nullopt;
  return drag.scaled(ratio);
}

}  // namespace brash::floes
