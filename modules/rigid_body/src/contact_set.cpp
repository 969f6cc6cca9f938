// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_set.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "contact_load.hpp"

namespace brash::rigid_body {
namespace {

/// Share of the overlap beyond kKeptOverlap that one step takes back by split impulse, where the ice is not breakable
/// [-].
constexpr double kPositionCorrection = 0.2;
/// Without an overlap there is no contact, and a body at rest on another would begin to fall [m].
constexpr double kKeptOverlap = 5e-4;

/// The other parts of the part's body.
void collect_others(const Part& part, std::vector<const Part*>& others) {
  others.clear();
  for (const auto& other : part.body->parts)
    if (other.get() != &part) others.push_back(other.get());
}

}  // namespace

void ContactSet::begin(Body& first) {
  first_ = &first;
  first_contact_ = contacts_.size();
  near_sheet_.clear();
}

void ContactSet::meet(const Body& second) {
  if (second.kind == BodyKind::kSheet)
    for (const auto& part : second.parts) near_sheet_.push_back(part.get());
}

void ContactSet::find(Body& one, Body& other) {
  Body& second = first_ == &one ? other : one;
  for (const auto& part : first_->parts)
    if (within_reach(box(*part), second.box, 0.0)) find(*part, second);
}

void ContactSet::find(const Part& part, Body& second) {
  collect_others(part, beside_first_);
  for (const auto& met : second.parts)
    if (within_reach(box(part), box(*met), 0.0) &&
        narrow_phase_.find({&part, met.get()}, beside_first_, beside(part, *met)))
      contacts_.push_back({first_, &second, part.number, narrow_phase_.normal, narrow_phase_.patch, law(second)});
}

/// The parts that continue the solid of the second part. The parts of the sheet that the first part meets continue each
/// other.
std::span<const Part* const> ContactSet::beside(const Part& part, const Part& of_second) {
  if (of_second.body->kind != BodyKind::kSheet) {
    collect_others(of_second, beside_second_);
    return beside_second_;
  }
  beside_second_.clear();
  for (const Part* tile : near_sheet_)
    if (tile != &of_second && within_reach(box(part), box(*tile), 0.0)) beside_second_.push_back(tile);
  return beside_second_;
}

/// Contacts of one part of the floe come in a row.
void ContactSet::end() {
  if (first_->parts.size() > 1)
    std::stable_sort(contacts_.begin() + static_cast<std::ptrdiff_t>(first_contact_), contacts_.end(),
                     [](const Contact& a, const Contact& b) { return a.first_part < b.first_part; });
}

void ContactSet::add(std::span<const GivenContact> given, const std::function<Body*(BodyId)>& find_body) {
  const std::size_t n_found = contacts_.size();
  for (const GivenContact& g : given) {
    Body* const other = g.other == kNoBody ? &ground_ : find_body(g.other);
    Patch patch{.area = g.area, .n_points = 1};
    patch.points[0] = {g.point, g.area};
    contacts_.push_back({find_body(g.body), other, 0, g.normal, patch, {g.friction, g.most_normal_force / g.area}});
  }
  std::sort(contacts_.begin() + static_cast<std::ptrdiff_t>(n_found), contacts_.end(),
            [](const Contact& a, const Contact& b) {
              const Vec3 &p = a.patch.points[0].position, &q = b.patch.points[0].position;
              return std::tie(a.first->rank, a.second->rank, p.x, p.y, p.z) <
                     std::tie(b.first->rank, b.second->rank, q.x, q.y, q.z);
            });
}

std::vector<Body*> ContactSet::settled_and_hit(double speed) const {
  std::vector<Body*> hit;
  for (const Contact& c : contacts_) {
    Body* const settled = c.first->settled ? c.first : c.second->settled ? c.second : nullptr;
    if (settled == nullptr) continue;
    const bool fast = std::ranges::any_of(c.points(), [&](const PatchPoint& p) {
      const Vec3 first = velocity_at(c.first->twist, p.position - c.first->pose.position);
      const Vec3 second = velocity_at(c.second->twist, p.position - c.second->pose.position);
      return dot(c.normal, second - first) > speed;
    });
    if (fast) hit.push_back(settled);
  }
  return hit;
}

/// Overlap of breakable ice is crushed ice: nothing pushes it apart.
void ContactSet::add_to(BoundedSolver& solver, double dt) const {
  for (const Contact& contact : contacts_) {
    if (!contact.moves_a_body()) continue;
    const ContactLaw& how = contact.law;
    const bool breakable = std::isfinite(how.crushing_pressure);
    solver.add({.first = contact.first->in_solver,
                .second = contact.second->in_solver,
                .normal = contact.normal,
                .friction = how.friction,
                .crushing_impulse = dt * how.crushing_pressure,
                .parting_speed =
                    breakable ? 0.0 : kPositionCorrection * std::max(0.0, contact.patch.depth - kKeptOverlap) / dt},
               contact.points());
  }
}

PointImpulse ContactSet::crushed(const Contact& contact, const PatchPoint& point, double dt) {
  const auto velocity = [&](const Body& b) { return velocity_at(b.twist, point.position - b.pose.position); };
  const Vec3 relative = velocity(*contact.first) - velocity(*contact.second);
  const double opening = dot(contact.normal, relative);
  if (opening >= 0.0) return {};
  const double normal = dt * contact.law.crushing_pressure * point.area;
  const Vec3 slip = relative - opening * contact.normal;
  const double speed = norm(slip);
  const Vec3 friction = speed > 0.0 ? (-contact.law.friction * normal / speed) * slip : Vec3{};
  return {.normal = normal, .friction = friction, .at_bound = true};
}

/// The load that the solver left in a contact point.
ContactLoad ContactSet::load(const Contact& contact, const PatchPoint& point, const PointImpulse& impulse, double dt) {
  const bool turn = contact.reported_turned();
  const double sign = turn ? -1.0 : 1.0;
  const Body& body = turn ? *contact.second : *contact.first;
  const Body& other = turn ? *contact.first : *contact.second;
  ContactLoad load = contact_load(body, other, point.position, point.position, sign * contact.normal, impulse.normal,
                                  sign * impulse.friction, dt);
  load.area = point.area;
  load.depth = contact.patch.depth;
  load.at_bound = impulse.at_bound;
  return load;
}

void ContactSet::report(const BoundedSolver& solver, double dt, std::vector<ContactLoad>& loads) {
  listed_.clear();
  std::size_t number = 0, unsolved = 0;
  for (const Contact& contact : contacts_) {
    const bool turn = contact.reported_turned();
    listed_.push_back({(turn ? contact.second : contact.first)->id, (turn ? contact.first : contact.second)->id,
                       contact.moves_a_body() ? number : unsolved, &contact});
    (contact.moves_a_body() ? number : unsolved) += contact.points().size();
  }
  const auto pair = [](const Listed& l) { return std::tie(l.body, l.other); };
  std::ranges::sort(listed_, [&](const Listed& a, const Listed& b) {
    return pair(a) != pair(b) ? pair(a) < pair(b) : a.number < b.number;
  });
  loads.clear();
  for (auto next = listed_.begin(); next != listed_.end();) {
    points_.clear();
    for (const Listed& first = *next; next != listed_.end() && pair(*next) == pair(first); ++next)
      for (std::size_t k = 0; k < next->contact->points().size(); ++k) {
        const Contact& contact = *next->contact;
        const PointImpulse impulse =
            contact.moves_a_body() ? solver.impulse(next->number + k) : crushed(contact, contact.points()[k], dt);
        if (impulse.normal != 0.0 || impulse.friction != Vec3{})
          points_.push_back({next->number + k, impulse, next->contact, &next->contact->points()[k]});
      }
    // Points in one place, of two parts of a floe, keep the order of the step: how many contacts there are besides,
    // which a resumed run may divide otherwise, must not change it.
    std::ranges::sort(points_, [](const ListedPoint& a, const ListedPoint& b) {
      const Vec3 &p = a.point->position, &q = b.point->position;
      return std::tie(p.x, p.y, p.z, a.number) < std::tie(q.x, q.y, q.z, b.number);
    });
    for (const ListedPoint& p : points_) loads.push_back(load(*p.contact, *p.point, p.impulse, dt));
  }
}

}  // namespace brash::rigid_body
