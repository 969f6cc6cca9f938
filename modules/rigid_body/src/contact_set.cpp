// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_set.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

namespace brash::rigid_body {
namespace {

/// The other parts of the part's body.
void collect_others(const Part& part, std::vector<const Part*>& others) {
  others.clear();
  for (const auto& other : part.body->parts)
    if (other.get() != &part) others.push_back(other.get());
}

}  // namespace

void ContactSet::find(const std::vector<PartPair>& pairs, double dt, std::vector<double>& bounds) {
  contacts_.clear();
  bounds.clear();
  for (std::size_t i = 0; i < pairs.size();) {
    // Pairs of one floe's part come in a row; the parts of the sheet among them continue each other.
    std::size_t end = i;
    near_sheet_.clear();
    for (; end < pairs.size() && pairs[end].first == pairs[i].first; ++end)
      if (pairs[end].second->body->kind == BodyKind::kSheet) near_sheet_.push_back(pairs[end].second);
    collect_others(*pairs[i].first, beside_first_);
    for (; i < end; ++i) {
      const Part& second = *pairs[i].second;
      if (second.body->kind == BodyKind::kSheet) {
        beside_second_ = near_sheet_;
        std::erase(beside_second_, &second);
      } else {
        collect_others(second, beside_second_);
      }
      if (narrow_phase_.find(pairs[i], beside_first_, beside_second_)) add(pairs[i], dt, bounds);
    }
  }
}

/// Eq. 16: the normal impulse of each point is bounded by dt sigma_c R times its share of the overlap's area.
void ContactSet::add(const PartPair& pair, double dt, std::vector<double>& bounds) {
  Contact& contact =
      contacts_.emplace_back(*pair.first->body, *pair.second->body, narrow_phase_.normal, narrow_phase_.patch);
  const ContactLaw& how = law(*contact.second);
  const bool breakable = std::isfinite(how.crushing_pressure);
  for (int i = 0; i < contact.patch.n_points; ++i) {
    const PatchPoint& p = contact.patch.points[static_cast<std::size_t>(i)];
    // Overlap of breakable ice is crushed ice: nothing pushes it apart, so the solver sees no depth.
    btManifoldPoint point(btVector3(0, 0, 0), btVector3(0, 0, 0), to_bullet(contact.normal),
                          breakable ? 0.0 : -contact.patch.depth);
    point.m_positionWorldOnA = point.m_positionWorldOnB = to_bullet(p.position);
    point.m_combinedFriction = how.friction;
    point.m_combinedRestitution = how.restitution;
    point.m_index0 = static_cast<int>(bounds.size());
    contact.manifold.addManifoldPoint(point);
    bounds.push_back(breakable ? dt * how.crushing_pressure * p.area : BT_LARGE_FLOAT);
  }
}

std::vector<Body*> ContactSet::settled_and_hit(double speed) const {
  std::vector<Body*> hit;
  for (const Contact& c : contacts_) {
    Body* const settled = c.first->settled ? c.first : c.second->settled ? c.second : nullptr;
    if (settled == nullptr) continue;
    const bool fast = std::ranges::any_of(
        std::span(c.patch.points).first(static_cast<std::size_t>(c.patch.n_points)), [&](const PatchPoint& p) {
          const Vec3 first = velocity_at(c.first->twist, p.position - c.first->pose.position);
          const Vec3 second = velocity_at(c.second->twist, p.position - c.second->pose.position);
          return dot(c.normal, second - first) > speed;
        });
    if (fast) hit.push_back(settled);
  }
  return hit;
}

std::vector<btPersistentManifold*> ContactSet::manifolds() {
  std::vector<btPersistentManifold*> manifolds;
  for (Contact& contact : contacts_) manifolds.push_back(&contact.manifold);
  return manifolds;
}

/// What the solver left in a contact point.
ContactLoad ContactSet::load(const Contact& contact, int point, double dt, const std::vector<double>& bounds) const {
  const bool turn = contact.reported_turned();
  const double sign = turn ? -1.0 : 1.0;
  const Body& body = turn ? *contact.second : *contact.first;
  const Body& other = turn ? *contact.first : *contact.second;
  const btManifoldPoint& p = contact.manifold.getContactPoint(point);
  const btVector3 friction =
      p.m_appliedImpulseLateral1 * p.m_lateralFrictionDir1 + p.m_appliedImpulseLateral2 * p.m_lateralFrictionDir2;
  const Vec3 at = from_bullet(p.m_positionWorldOnB);
  return {.body = body.id,
          .other = other.id,
          .other_kind = other.kind,
          .point = at,
          .normal = sign * contact.normal,
          .normal_force = p.m_appliedImpulse / dt,
          .friction_force = (sign / dt) * from_bullet(friction),
          .area = contact.patch.points[static_cast<std::size_t>(point)].area,
          .depth = contact.patch.depth,
          .at_bound = p.m_appliedImpulse >= bounds[static_cast<std::size_t>(p.m_index0)],
          .body_velocity = velocity_at(body.mean_twist, at - body.pose.position),
          .other_velocity = velocity_at(other.mean_twist, at - other.pose.position)};
}

void ContactSet::report(double dt, const std::vector<double>& bounds, std::vector<ContactLoad>& loads) {
  listed_.clear();
  for (const Contact& contact : contacts_) {
    const bool turn = contact.reported_turned();
    for (int i = 0; i < contact.manifold.getNumContacts(); ++i)
      listed_.push_back({(turn ? contact.second : contact.first)->id, (turn ? contact.first : contact.second)->id,
                         from_bullet(contact.manifold.getContactPoint(i).m_positionWorldOnB), &contact, i});
  }
  // Points in one place, of two parts of a floe, keep the order of the step: how many contacts there are besides, which
  // a resumed run may divide otherwise, must not change it.
  const auto key = [](const Listed& l) { return std::tie(l.body, l.other, l.place.x, l.place.y, l.place.z); };
  std::ranges::stable_sort(listed_, [&](const Listed& a, const Listed& b) { return key(a) < key(b); });
  loads.clear();
  for (const Listed& l : listed_) loads.push_back(load(*l.contact, l.point, dt, bounds));
}

}  // namespace brash::rigid_body
