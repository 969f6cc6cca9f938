// SPDX-License-Identifier: GPL-3.0-or-later
#include "body.hpp"

#include <BulletCollision/CollisionShapes/btCompoundShape.h>
#include <BulletCollision/CollisionShapes/btEmptyShape.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace brash::rigid_body {

Part::Part(Body& owner, int which, ConvexPart shape) : body(&owner), number(which), solid(std::move(shape)) {
  now.part = &solid;
}

bool within_reach(const Box& a, const Box& b, double reach) {
  return a.lower.x <= b.upper.x + reach && b.lower.x <= a.upper.x + reach && a.lower.y <= b.upper.y + reach &&
         b.lower.y <= a.upper.y + reach && a.lower.z <= b.upper.z + reach && b.lower.z <= a.upper.z + reach;
}

bool Body::add_part(ConvexPart solid, double margin) {
  if (!outlasts_inset(solid, margin)) return false;
  parts.push_back(std::make_unique<Part>(*this, static_cast<int>(parts.size()), std::move(solid)));
  return true;
}

void Body::make_bullet_body(double margin) {
  for (const auto& part : parts) {
    const std::vector<Vec3> corners = margin > 0.0 ? inset_vertices(part->solid, margin) : part->solid.vertices;
    hulls.push_back(std::make_unique<btConvexHullShape>(&corners[0].x, static_cast<int>(corners.size()),
                                                        static_cast<int>(sizeof(Vec3))));
    hulls.back()->setMargin(margin);
  }
  if (hulls.empty()) shape = std::make_unique<btEmptyShape>();
  if (hulls.size() > 1) {
    auto compound = std::make_unique<btCompoundShape>(margin > 0.0, static_cast<int>(hulls.size()));
    for (const auto& hull : hulls) compound->addChildShape(btTransform::getIdentity(), hull.get());
    shape = std::move(compound);
  }
  const btRigidBody::btRigidBodyConstructionInfo info(mass.mass, nullptr, shape ? shape.get() : hulls[0].get(),
                                                      to_bullet(mass.inertia));
  bullet = std::make_unique<btRigidBody>(info);
  bullet->setUserPointer(this);
  bullet->setFlags(0);  // the gyroscopic term is added before the solve, so that friction sees it too
  bullet->setActivationState(DISABLE_DEACTIVATION);
  if (kind == BodyKind::kStructure && mass.mass == 0.0)
    bullet->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
}

void Body::set_mass(const MassProperties& value) {
  mass = value;
  bullet->setMassProps(value.mass, to_bullet(value.inertia));
  bullet->updateInertiaTensor();
}

void Body::set_settled(bool value) {
  settled = value;
  start_pose = pose;
  twist = {};
  start_twist = {};
  mean_twist = {};
  loaded_twist = {};
  gyroscopic_share = 0.0;
  load = {};
  stream = {};
  bullet->setMassProps(value ? 0.0 : mass.mass, value ? btVector3(0, 0, 0) : to_bullet(mass.inertia));
  bullet->updateInertiaTensor();
  bullet->setLinearVelocity({0, 0, 0});  // the step that lets it go has made its velocities already
  bullet->setAngularVelocity({0, 0, 0});
}

void Body::place() {
  box = {};
  for (const auto& part : parts) {
    update(part->now, pose);
    const auto& [low, up] = std::tie(part->now.lower, part->now.upper);
    box.lower = {std::min(box.lower.x, low.x), std::min(box.lower.y, low.y), std::min(box.lower.z, low.z)};
    box.upper = {std::max(box.upper.x, up.x), std::max(box.upper.y, up.y), std::max(box.upper.z, up.z)};
  }
  box_is_known = false;
  bullet->setWorldTransform(to_bullet(pose));
  bullet->updateInertiaTensor();
}

double Body::kinetic_energy() const {
  const Vec3 w = rotate(conjugate(pose.rotation), twist.angular);
  const double across = dot(rotate(pose.rotation, {0.0, 0.0, 1.0}), twist.linear);
  return 0.5 * mass.mass * dot(twist.linear, twist.linear) + 0.5 * mass.added_across * across * across +
         0.5 * (mass.inertia.x * w.x * w.x + mass.inertia.y * w.y * w.y + mass.inertia.z * w.z * w.z);
}

Vec3 Body::angular_momentum(Vec3 spin) const {
  const Vec3 w = rotate(conjugate(pose.rotation), spin);
  return rotate(pose.rotation, {mass.inertia.x * w.x, mass.inertia.y * w.y, mass.inertia.z * w.z});
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
