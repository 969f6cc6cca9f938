// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace brash {

/// Plan vector, sheet frame: x along the structure's track, y to port, the waterplane is z = 0.
struct Vec2 {
  double x = 0.0;
  double y = 0.0;

  friend constexpr bool operator==(const Vec2&, const Vec2&) = default;
  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
  friend constexpr Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
  friend constexpr Vec2 operator*(Vec2 a, double s) { return s * a; }
  friend constexpr Vec2 operator/(Vec2 a, double s) { return {a.x / s, a.y / s}; }
  constexpr Vec2& operator+=(Vec2 b) { return *this = *this + b; }
};

constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
inline double norm(Vec2 a) { return std::hypot(a.x, a.y); }
inline Vec2 normalized(Vec2 a) { return a / norm(a); }
/// `a` turned by +90 degrees.
constexpr Vec2 perpendicular(Vec2 a) { return {-a.y, a.x}; }

/// Vector in space, world frame: the sheet frame with z upwards from the waterplane.
struct Vec3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
  friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
  friend constexpr Vec3 operator*(Vec3 a, double s) { return s * a; }
  friend constexpr Vec3 operator/(Vec3 a, double s) { return {a.x / s, a.y / s, a.z / s}; }
  constexpr Vec3& operator+=(Vec3 b) { return *this = *this + b; }
  constexpr Vec3& operator-=(Vec3 b) { return *this = *this - b; }
};

constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(Vec3 a) { return std::sqrt(dot(a, a)); }
inline Vec3 normalized(Vec3 a) { return a / norm(a); }
constexpr Vec2 plan(Vec3 a) { return {a.x, a.y}; }

/// Unit quaternion, rotation from the body frame to the world frame.
struct Quaternion {
  double w = 1.0;
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  friend constexpr bool operator==(const Quaternion&, const Quaternion&) = default;
};

/// `v` turned by `q`.
constexpr Vec3 rotate(const Quaternion& q, Vec3 v) {
  const Vec3 u{q.x, q.y, q.z};
  const Vec3 t = 2.0 * cross(u, v);
  return v + q.w * t + cross(u, t);
}
constexpr Quaternion conjugate(const Quaternion& q) { return {q.w, -q.x, -q.y, -q.z}; }

/// Place and attitude of a body: the body frame's origin (its centre of mass) and axes in the world frame.
struct Pose {
  Vec3 position{};
  Quaternion rotation{};

  friend constexpr bool operator==(const Pose&, const Pose&) = default;
};

/// Point given in the body frame, in the world frame [m].
constexpr Vec3 to_world(const Pose& pose, Vec3 body_point) { return pose.position + rotate(pose.rotation, body_point); }
/// Point given in the world frame, in the body frame [m].
constexpr Vec3 to_body(const Pose& pose, Vec3 world_point) {
  return rotate(conjugate(pose.rotation), world_point - pose.position);
}

/// Velocity of a body: of its centre of mass [m/s] and angular [rad/s], world frame.
struct Twist {
  Vec3 linear{};
  Vec3 angular{};

  friend constexpr bool operator==(const Twist&, const Twist&) = default;
};

/// Velocity of the material point at `r` from the centre of mass [m/s].
constexpr Vec3 velocity_at(const Twist& twist, Vec3 r) { return twist.linear + cross(twist.angular, r); }

/// Force [N] and moment about a stated point [N m], world frame.
struct Wrench {
  Vec3 force{};
  Vec3 moment{};

  constexpr Wrench& operator+=(const Wrench& other) {
    force += other.force;
    moment += other.moment;
    return *this;
  }
  friend constexpr bool operator==(const Wrench&, const Wrench&) = default;
};

/// Of a load on a body that moves so, the moment and the velocity about the same point [W].
constexpr double power(const Wrench& load, const Twist& twist) {
  return dot(load.force, twist.linear) + dot(load.moment, twist.angular);
}

}  // namespace brash
