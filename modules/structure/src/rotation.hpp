// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "brash/core/vec.hpp"

namespace brash::structure {

/// The rotation `b` first, then `a`.
constexpr Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

inline Quaternion normalized(const Quaternion& q) {
  const double size = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w / size, q.x / size, q.y / size, q.z / size};
}

/// The rotation by the angle |v| about v [rad].
inline Quaternion rotation_by(Vec3 v) {
  const double angle = norm(v);
  if (angle == 0.0) return {};
  const double s = std::sin(0.5 * angle) / angle;
  return {std::cos(0.5 * angle), s * v.x, s * v.y, s * v.z};
}

/// The shorter rotation vector of a unit quaternion [rad].
inline Vec3 rotation_vector(const Quaternion& q) {
  const Vec3 axis{q.x, q.y, q.z};
  const double sine = norm(axis);
  if (sine == 0.0) return {};
  const double half = std::atan2(sine, std::abs(q.w));
  return (q.w < 0.0 ? -2.0 : 2.0) * half / sine * axis;
}

/// `q` turned further by `v` about the world's axes [rad].
inline Quaternion turned(const Quaternion& q, Vec3 v) {
  return v == Vec3{} ? q : normalized(product(rotation_by(v), q));
}

/// The shorter turn from one attitude to another, about the world's axes [rad].
inline Vec3 turn_between(const Quaternion& from, const Quaternion& to) {
  return rotation_vector(normalized(product(to, conjugate(from))));
}

inline bool is_finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace brash::structure
