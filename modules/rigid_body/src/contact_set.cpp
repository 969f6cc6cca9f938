// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_set.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "contact_load.hpp"

namespace brash::rigid_body {
namespace {

/// Share of the overlap beyond kKeptOverlap that one step takes back by split impulse, where the ice is not breakable
/// [-].
constexpr double kPositionCorrection = 0.2;
/// Without an overlap there is no contact, and a body at rest on another would begin to fall [m].
constexpr double kKeptOverlap = 5e-4;

/// Floes or bodies that a thread takes at a time, at some 5 us for each.
constexpr std::size_t kFloes = 16;
/// Bodies over the bed that a thread takes at a time: some ns for each, 1 us on the bed.
constexpr std::size_t kOverBed = 64;
/// Contacts that a thread looks at, at some 30 ns for each.
constexpr std::size_t kContacts = 256;

/// The other parts of the part's body.
void collect_others(const Part& part, std::vector<const Part*>& others) {
  others.clear();
  for (const auto& other : part.body->parts)
    if (other.get() != &part) others.push_back(other.get());
}

}  // namespace

void ContactSet::find(std::span<const Meeting> meetings, btDispatcher& dispatcher, Workers& workers) {
  searches_.resize(static_cast<std::size_t>(workers.count()));
  found_.resize(meetings.size() / kFloes + 1);
  for (Found& found : found_) {
    found.contacts.clear();
    found.hit.clear();
  }
  workers.chunks(meetings.size(), kFloes, [&](std::size_t begin, std::size_t end, int worker) {
    for (std::size_t i = begin; i < end; ++i)
      find(meetings[i], dispatcher, searches_[static_cast<std::size_t>(worker)], found_[begin / kFloes]);
  });
  contacts_.clear();
  for (const Found& found : found_)
    for (const Contact& contact : found.contacts) contacts_.push_back(&contact);
}

/// Contacts of one part of the floe come in a row.
void ContactSet::find(const Meeting& meeting, btDispatcher& dispatcher, Search& search, Found& found) const {
  const Body& first = *meeting.first;
  std::vector<Contact>& contacts = found.contacts;
  const auto n_before = static_cast<std::ptrdiff_t>(contacts.size());
  search.near_sheet.clear();
  for (const BodyPair& pair : meeting.pairs)
    if (pair.second->kind == BodyKind::kSheet)
      for (const auto& part : pair.second->parts) search.near_sheet.push_back(part.get());
  for (const BodyPair& pair : meeting.pairs) {
    if (!dispatcher.needsCollision(first.bullet.get(), pair.second->bullet.get())) continue;
    for (const auto& part : first.parts)
      if (within_reach(box(*part), pair.second->box, 0.0)) find(*part, *pair.second, search, contacts);
  }
  if (first.parts.size() > 1)
    std::stable_sort(contacts.begin() + n_before, contacts.end(),
                     [](const Contact& a, const Contact& b) { return a.first_part < b.first_part; });
  for (auto contact = contacts.begin() + n_before; contact != contacts.end(); ++contact)
    if (hits_settled(*contact)) found.hit.push_back(contact->first->settled ? contact->first : contact->second);
}

void ContactSet::find(const Part& part, Body& second, Search& search, std::vector<Contact>& contacts) const {
  for (const auto& met : second.parts) {
    if (!within_reach(box(part), box(*met), 0.0) || !search.narrow_phase.overlap({&part, met.get()})) continue;
    if (search.narrow_phase.find_contact(search.beside(part, *met)))
      contacts.push_back({part.body, &second, part.number, search.narrow_phase.normal, search.narrow_phase.patch,
                          law(second), part.body->gives_way() || second.gives_way()});
  }
}

void ContactSet::find_on_bed(std::span<Body* const> bodies, Workers& workers) {
  if (!bed_) return;
  on_bed_.resize(bodies.size() / kOverBed + 1);
  for (std::vector<Contact>& contacts : on_bed_) contacts.clear();
  workers.chunks(bodies.size(), kOverBed, [&](std::size_t begin, std::size_t end, int worker) {
    OverlapFinder& finder = searches_[static_cast<std::size_t>(worker)].below;
    for (const Body* const body : bodies.subspan(begin, end - begin))
      if (body->is_floe() && !body->settled && body->box.lower.z < bed_->height)
        find_on_bed(*body, finder, on_bed_[begin / kOverBed]);
  });
  for (const std::vector<Contact>& contacts : on_bed_)
    for (const Contact& contact : contacts) contacts_.push_back(&contact);
}

/// The direction is known, so no face between two parts of a floe can be one.
void ContactSet::find_on_bed(const Body& floe, OverlapFinder& finder, std::vector<Contact>& contacts) {
  constexpr Vec3 kUpwards{0.0, 0.0, 1.0};
  for (const auto& part : floe.parts) {
    finder.below(part->now, {kUpwards, bed_->height});
    const Patch& patch = finder.project(kUpwards);
    if (patch.n_points > 0)
      contacts.push_back({part->body, &bed_body_, part->number, kUpwards, patch, bed_->law, /*moves_a_body=*/true});
  }
}

/// The parts of one sheet that the first part meets continue each other.
Beside ContactSet::Search::beside(const Part& part, const Part& of_second) {
  collect_others(part, beside_first);
  if (of_second.body->kind != BodyKind::kSheet) {
    collect_others(of_second, beside_second);
    return {beside_first, beside_second};
  }
  beside_second.clear();
  for (const Part* tile : near_sheet)
    if (tile != &of_second && tile->body->sheet == of_second.body->sheet && within_reach(box(part), box(*tile), 0.0))
      beside_second.push_back(tile);
  return {beside_first, beside_second};
}

bool ContactSet::hits_settled(const Contact& c) const {
  return (c.first->settled || c.second->settled) && closes_fast(c, c.first->twist, c.second->twist);
}

bool ContactSet::closes_fast(const Contact& c, const Twist& first, const Twist& second) const {
  return std::ranges::any_of(c.points(), [&](const PatchPoint& p) {
    const Vec3 of_first = velocity_at(first, p.position - c.first->pose.position);
    const Vec3 of_second = velocity_at(second, p.position - c.second->pose.position);
    return dot(c.normal, of_second - of_first) > release_speed_;
  });
}

bool ContactSet::is_of_struck_and_settled(const Contact& c) {
  return (c.first->struck && c.second->settled) || (c.first->settled && c.second->struck);
}

bool ContactSet::struck_touch_settled() const {
  return std::ranges::any_of(contacts_, [](const Contact* c) { return is_of_struck_and_settled(*c); });
}

std::vector<Body*> ContactSet::settled_and_hit() const {
  std::vector<Body*> hit;
  for (const Found& found : found_) hit.insert(hit.end(), found.hit.begin(), found.hit.end());
  return hit;
}

std::vector<Body*> ContactSet::settled_and_hit(const BoundedSolver& solver) const {
  std::vector<Body*> hit;
  const auto twist = [&](const Body& body) { return body.settled ? Twist{} : solver.twist(body.in_solver); };
  for (const Contact* const c : contacts_)
    if (is_of_struck_and_settled(*c) && closes_fast(*c, twist(*c->first), twist(*c->second)))
      hit.push_back(c->first->settled ? c->first : c->second);
  return hit;
}

/// Overlap of breakable ice is crushed ice: nothing pushes it apart.
void ContactSet::add_to(BoundedSolver& solver, double dt, Workers& workers, Which which) {
  solved_.clear();
  for (const Contact* const contact : contacts_)
    if (contact->moves_a_body && (which == Which::kAll || !is_of_struck_and_settled(*contact)))
      solved_.push_back(contact);
  solver.add_contacts(solved_.size(), workers, [&](std::size_t i) {
    const Contact& contact = *solved_[i];
    const ContactLaw& how = contact.law;
    const bool breakable = std::isfinite(how.crushing_pressure);
    const double excess = std::max(0.0, contact.patch.depth - kKeptOverlap);
    return BoundedSolver::Given{{.first = contact.first->in_solver,
                                 .second = contact.second->in_solver,
                                 .normal = contact.normal,
                                 .friction = how.friction,
                                 .crushing_impulse = dt * how.crushing_pressure,
                                 .parting_speed = breakable ? 0.0 : kPositionCorrection * excess / dt},
                                contact.points()};
  });
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

// The report. `reported_` is indexed like `contacts_`, in the order of the step. `listed_` holds the same contacts body
// by body: of_body_[b - 1] to of_body_[b] are the contacts of the body with index b, once they are dealt out. The
// solver numbers the points of its contacts in the order of the step: Listed::solved is the number of a contact's first
// one.

/// Deals the contacts out to the bodies from which they are reported.
void ContactSet::list_by_body(Workers& workers) {
  // Contacts and bodies lie all over the memory: all threads fetch them.
  reported_.resize(contacts_.size());
  workers.each(contacts_.size(), kContacts, [this](std::size_t i) {
    const Contact& contact = *contacts_[i];
    const bool turn = contact.reported_turned();
    const Body& body = turn ? *contact.second : *contact.first;
    const Body& other = turn ? *contact.first : *contact.second;
    // All the sheet counts as one: a resumed run lays other tiles, with other ids.
    const BodyId listed = other.kind == BodyKind::kSheet ? kNoBody : other.id;
    reported_[i] = {body.id.index, contact.moves_a_body ? contact.points().size() : 0, {listed, i, 0, &contact}};
  });
  of_body_.clear();
  for (const Reported& reported : reported_) {
    if (reported.body + 1 >= of_body_.size()) of_body_.resize(reported.body + 2, 0);
    ++of_body_[reported.body + 1];
  }
  std::partial_sum(of_body_.begin(), of_body_.end(), of_body_.begin());
  listed_.resize(contacts_.size());
  std::size_t solved = 0;
  for (Reported& reported : reported_) {
    reported.listed.solved = solved;
    listed_[of_body_[reported.body]++] = reported.listed;
    solved += reported.n_solved;
  }
}

void ContactSet::report(const BoundedSolver& solver, double dt, std::vector<ContactLoad>& loads, Workers& workers) {
  list_by_body(workers);
  const std::size_t n_bodies = of_body_.size();
  points_.resize(static_cast<std::size_t>(workers.count()));
  loads_.resize(n_bodies / kFloes + 1);
  workers.chunks(n_bodies, kFloes, [&](std::size_t begin, std::size_t end, int worker) {
    std::vector<ContactLoad>& some = loads_[begin / kFloes];
    some.clear();
    for (std::size_t body = begin; body < end; ++body) {
      const std::size_t first = body == 0 ? 0 : of_body_[body - 1];
      report_body(std::span(listed_).subspan(first, of_body_[body] - first), solver, dt,
                  points_[static_cast<std::size_t>(worker)], some);
    }
  });
  loads.clear();
  for (std::size_t i = 0; i * kFloes < n_bodies; ++i) loads.insert(loads.end(), loads_[i].begin(), loads_[i].end());
}

/// Adds the loads of the contacts of a body.
void ContactSet::report_body(std::span<Listed> listed, const BoundedSolver& solver, double dt,
                             std::vector<ListedPoint>& points, std::vector<ContactLoad>& loads) const {
  std::ranges::sort(listed, [&](const Listed& a, const Listed& b) {
    return std::tie(a.other, a.number) < std::tie(b.other, b.number);
  });
  for (auto next = listed.begin(); next != listed.end();) {
    points.clear();
    for (const BodyId other = next->other; next != listed.end() && next->other == other; ++next)
      for (std::size_t k = 0; k < next->contact->points().size(); ++k) {
        const Contact& contact = *next->contact;
        const PointImpulse impulse =
            contact.moves_a_body ? solver.impulse(next->solved + k) : crushed(contact, contact.points()[k], dt);
        if (impulse.normal != 0.0 || impulse.friction != Vec3{})
          points.push_back({next->number, impulse, next->contact, &next->contact->points()[k]});
      }
    // Points in one place, of two parts of a floe, keep the order of the step: how many contacts there are besides,
    // which a resumed run may divide otherwise, must not change it.
    std::ranges::sort(points, [](const ListedPoint& a, const ListedPoint& b) {
      const Vec3 &p = a.point->position, &q = b.point->position;
      return std::tie(p.x, p.y, p.z, a.number, a.point) < std::tie(q.x, q.y, q.z, b.number, b.point);
    });
    for (const ListedPoint& p : points) loads.push_back(load(*p.contact, *p.point, p.impulse, dt));
  }
}

}  // namespace brash::rigid_body
