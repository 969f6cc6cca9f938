// SPDX-License-Identifier: GPL-3.0-or-later
#include "turning.hpp"

#include <cmath>

#include "body.hpp"

namespace brash::rigid_body {
namespace {

/// An iteration leaves the square of the turn of a step as a share of the error: a few reach the round-off.
constexpr int kMostIterations = 20;

/// tan(rate dt / 2) / rate [s].
double half_turn(double rate, double dt) {
  const double half = 0.5 * rate * dt;
  return half > 1e-4 ? std::tan(half) / rate : 0.5 * dt * (1.0 + half * half / 3.0);
}

}  // namespace

Turn turned_with_water(const MassProperties& mass, const Pose& pose, const Twist& twist, Vec3 stream, double dt) {
  const Vec3 along_z{0.0, 0.0, 1.0};
  const Vec3 P = momentum(mass, pose, twist.linear - stream);
  const Vec3 n = rotate(pose.rotation, along_z);
  const double lag = 1.0 / mass.mass - 1.0 / (mass.mass + mass.added_across);
  Vec3 middle = twist.angular, angular = twist.angular;
  Pose after;
  for (int i = 0; i < kMostIterations; ++i) {
    after = advanced(pose, {twist.linear, middle}, dt);
    // Munk's moment as a discrete gradient: its work at the middle spin is the loss of translational energy, exactly.
    const Vec3 N = n + rotate(after.rotation, along_z);
    const Vec3 impulse = 0.5 * lag * half_turn(norm(middle), dt) * dot(N, P) * cross(N, P);
    const Vec3 in_body = rotate(conjugate(pose.rotation), impulse);
    const Vec3 gained{in_body.x / mass.inertia.x, in_body.y / mass.inertia.y, in_body.z / mass.inertia.z};
    const Vec3 next = twist.angular + 0.5 * rotate(pose.rotation, gained);
    angular = rotate(after.rotation, rotate(conjugate(pose.rotation), twist.angular) + gained);
    if (next == middle) break;
    middle = next;
  }
  return {after, {stream + velocity_of(mass, after, P), angular}};
}

}  // namespace brash::rigid_body
