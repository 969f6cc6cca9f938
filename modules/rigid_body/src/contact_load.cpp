// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_load.hpp"

namespace brash::rigid_body {

ContactLoad contact_load(const Body& body, const Body& other, Vec3 of_body, Vec3 of_other, Vec3 normal,
                         double normal_impulse, Vec3 friction_impulse, double dt) {
  const auto velocity = [](const Body& b, Vec3 at, Twist twist) { return velocity_at(twist, at - b.pose.position); };
  const auto gained = [&](const Body& b, Vec3 at) {
    return velocity(b, at, b.loaded_twist) - velocity(b, at, b.twist);
  };
  const Vec3 body_velocity = velocity(body, of_body, body.mean_twist);
  const Vec3 other_velocity = velocity(other, of_other, other.mean_twist);
  const Vec3 force = (1.0 / dt) * (normal_impulse * normal + friction_impulse);
  return {.body = body.id,
          .other = other.id,
          .other_kind = other.kind,
          .point = of_body,
          .normal = normal,
          .normal_force = normal_impulse / dt,
          .friction_force = (1.0 / dt) * friction_impulse,
          .body_velocity = body_velocity,
          .other_velocity = other_velocity,
          .loss = -dt *
                  dot(force, body_velocity - other_velocity + 0.5 * (gained(body, of_body) - gained(other, of_other)))};
}

}  // namespace brash::rigid_body
