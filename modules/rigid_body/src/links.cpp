// SPDX-License-Identifier: GPL-3.0-or-later
#include "links.hpp"

#include <algorithm>
#include <cmath>

#include "brash/core/contract.hpp"

namespace brash::rigid_body {
namespace {

Vec3 arm(const Body& body, Vec3 point) { return rotate(body.pose.rotation, point); }

}  // namespace

Links::~Links() {
  for (Link& link : links_) unhook(link);
}

void Links::unhook(Link& link) { world_->removeConstraint(link.constraint.get()); }

LinkId Links::add(Body& body, Vec3 point, Body* other, Vec3 other_point, const LinkLaw& law) {
  BRASH_EXPECTS(law.stiffness > 0.0 && law.damping >= 0.0, law.stiffness, law.damping);
  const LinkId id{next_++, 0};
  btRigidBody& second = other != nullptr ? *other->bullet : fixed_;
  auto constraint =
      std::make_unique<btPoint2PointConstraint>(*body.bullet, second, to_bullet(point), to_bullet(other_point));
  auto feedback = std::make_unique<btJointFeedback>();
  constraint->setJointFeedback(feedback.get());
  constraint->setUserConstraintId(static_cast<int>(id.index));
  world_->addConstraint(constraint.get(), other != nullptr);
  links_.push_back({id, &body, other, point, other_point, law, std::move(constraint), std::move(feedback)});
  return id;
}

bool Links::contains(LinkId id) const { return std::ranges::binary_search(links_, id, {}, &Link::id); }

void Links::remove(LinkId id) {
  BRASH_EXPECTS(contains(id), "no such link", id.index);
  const auto link = std::ranges::lower_bound(links_, id, {}, &Link::id);
  unhook(*link);
  links_.erase(link);
}

bool Links::hold(const Body& body) const {
  return std::ranges::any_of(links_, [&](const Link& l) { return l.body == &body || l.other == &body; });
}

void Links::forget(const Body& body) {
  std::erase_if(links_, [&](Link& link) {
    const bool tied = link.body == &body || link.other == &body;
    if (tied) unhook(link);
    return tied;
  });
}

/// A spring k with a damper c, both taken at the end of the step: the relative velocity v' and the impulse P obey
/// v' + P / (dt (dt k + c)) = -k gap / (dt k + c).
void Links::prepare(double dt) {
  for (Link& link : links_) {
    const auto [k, c] = link.law;
    if (std::isinf(k)) continue;
    link.constraint->setParam(BT_CONSTRAINT_ERP, dt * k / (dt * k + c));
    link.constraint->setParam(BT_CONSTRAINT_CFM, 1.0 / (dt * (dt * k + c)));
  }
}

void Links::report(double dt) {
  loads_.clear();
  for (const Link& link : links_) {
    const Vec3 force = from_bullet(link.feedback->m_appliedForceBodyA);
    const Vec3 r = arm(*link.body, link.point);
    const Vec3 other_r = link.other != nullptr ? arm(*link.other, link.other_point) : Vec3{};
    const auto relative = [&](Twist Body::*twist) {
      const Vec3 v = velocity_at(link.body->*twist, r);
      return link.other != nullptr ? v - velocity_at(link.other->*twist, other_r) : v;
    };
    const Vec3 mean = relative(&Body::mean_twist);
    const Vec3 gained = relative(&Body::loaded_twist) - relative(&Body::twist);
    loads_.push_back({.link = link.id,
                      .body = link.body->id,
                      .other = link.other != nullptr ? link.other->id : kNoBody,
                      .point = link.body->pose.position + r,
                      .force = force,
                      .relative_velocity = mean,
                      .loss = -dt * dot(force, mean + 0.5 * gained)});
  }
}

void Links::measure() {
  for (std::size_t i = 0; i < loads_.size(); ++i) {
    const Link& link = links_[i];
    const Vec3 one = link.body->pose.position + arm(*link.body, link.point);
    const Vec3 other =
        link.other != nullptr ? link.other->pose.position + arm(*link.other, link.other_point) : link.other_point;
    loads_[i].gap = norm(one - other);
    const double k = link.law.stiffness;
    if (std::isfinite(k)) loads_[i].elastic_energy = 0.5 * k * dot(one - other, one - other);
  }
}

}  // namespace brash::rigid_body
