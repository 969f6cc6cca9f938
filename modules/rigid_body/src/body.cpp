// SPDX-License-Identifier: GPL-3.0-or-later
#include "body.hpp"

#include <array>
#include <cmath>

namespace brash::rigid_body {

Part::Part(Body& owner, int which, ConvexPart shape) : body(&owner), number(which), solid(std::move(shape)) {
  now.part = &solid;
  update(now, owner.pose);
}

bool Body::add_part(ConvexPart solid, double margin) {
  if (inset_vertices(solid, margin).size() < 4) return false;
  parts.push_back(std::make_unique<Part>(*this, static_cast<int>(parts.size()), std::move(solid)));
  return true;
}

void Body::make_bullet_body() {
  const btRigidBody::btRigidBodyConstructionInfo info(mass.mass, nullptr, nullptr, to_bullet(mass.inertia));
  bullet = std::make_unique<btRigidBody>(info);
  bullet->setFlags(0);  // the gyroscopic term is added before the solve, so that friction sees it too
}

void Body::set_settled(bool value) {
  settled = value;
  twist = {};
  mean_twist = {};
  loaded_twist = {};
  load = {};
  update_bullet();  // the step that lets it go has made its velocities already
}

void Body::place_parts() {
  for (const auto& part : parts) update(part->now, pose);
}

void Body::update_bullet() {
  bullet->setWorldTransform(to_bullet(pose));
  bullet->setLinearVelocity(to_bullet(twist.linear));
  bullet->setAngularVelocity(to_bullet(twist.angular));
  bullet->updateInertiaTensor();
}

double Body::kinetic_energy() const {
  const Vec3 w = rotate(conjugate(pose.rotation), twist.angular);
  return 0.5 * mass.mass * dot(twist.linear, twist.linear) +
         0.5 * (mass.inertia.x * w.x * w.x + mass.inertia.y * w.y * w.y + mass.inertia.z * w.z * w.z);
}

Pose advanced(const Pose& pose, const Twist& twist, double dt) {
  const double rate = norm(twist.angular);
  if (rate == 0.0) return {pose.position + dt * twist.linear, pose.rotation};  // rest is rest, to the last bit
  const double half = 0.5 * rate * dt;
  // sin(half) / rate without the division by zero.
  const double s = half > 1e-4 ? std::sin(half) / rate : 0.5 * dt * (1.0 - half * half / 6.0);
  const Quaternion d{std::cos(half), s * twist.angular.x, s * twist.angular.y, s * twist.angular.z};
  const Quaternion& q = pose.rotation;
  Quaternion r{d.w * q.w - d.x * q.x - d.y * q.y - d.z * q.z, d.w * q.x + d.x * q.w + d.y * q.z - d.z * q.y,
               d.w * q.y - d.x * q.z + d.y * q.w + d.z * q.x, d.w * q.z + d.x * q.y - d.y * q.x + d.z * q.w};
  const double length = std::sqrt(r.w * r.w + r.x * r.x + r.y * r.y + r.z * r.z);
  r = {r.w / length, r.x / length, r.y / length, r.z / length};
  return {pose.position + dt * twist.linear, r};
}

bool is_finite(const Pose& pose, const Twist& twist) {
  const auto finite = [](Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
  const Quaternion& q = pose.rotation;
  return finite(pose.position) && finite(twist.linear) && finite(twist.angular) && std::isfinite(q.w) &&
         std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z);
}

bool comes_before(const Body& a, const Body& b) {
  if (a.pose.position.x != b.pose.position.x) return a.pose.position.x < b.pose.position.x;
  const auto key = [](const Body& body) {
    const Vec3& p = body.pose.position;
    const Quaternion& q = body.pose.rotation;
    const Vec3 lower = body.parts.empty() ? Vec3{} : body.parts[0]->now.lower;
    const Vec3 upper = body.parts.empty() ? Vec3{} : body.parts[0]->now.upper;
    return std::array{p.x,     p.y,     p.z,     q.w,     q.x,     q.y,     q.z,
                      lower.x, lower.y, lower.z, upper.x, upper.y, upper.z, body.mass.mass};
  };
  const auto key_a = key(a);
  const auto key_b = key(b);
  return key_a != key_b ? key_a < key_b : a.id < b.id;
}

}  // namespace brash::rigid_body
