// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet_contacts.hpp"

#include <algorithm>
#include <tuple>

#include "contact_load.hpp"

namespace brash::rigid_body {
namespace {

/// Of the sheet of a part; before all sheets where it has none.
int rank_of_sheet(const Body& part) { return part.sheet != nullptr ? part.sheet->rank : -1; }

/// The sheet that gives way comes first, and of two the one that is first in the step.
BodyPair turned(const BodyPair& pair) {
  const auto place = [](const Body& part) { return std::pair(!part.gives_way(), rank_of_sheet(part)); };
  return place(*pair.second) < place(*pair.first) ? BodyPair{pair.second, pair.first} : pair;
}

}  // namespace

/// What lies beside a part in the overlap with another is a part of its sheet that the other meets too.
void SheetContacts::list_met(std::span<const BodyPair> pairs) {
  met_.clear();
  for (const auto& [first, second] : pairs) {
    for (const auto& part : second->parts) met_.emplace_back(first->rank, part.get());
    for (const auto& part : first->parts) met_.emplace_back(second->rank, part.get());
  }
  std::ranges::stable_sort(met_, {}, &std::pair<int, const Part*>::first);
}

/// The other parts of the sheet of `body` that `met_by` meets.
std::span<const Part* const> SheetContacts::beside(const Body& body, const Body& met_by,
                                                   std::vector<const Part*>& parts) const {
  parts.clear();
  auto met = std::ranges::lower_bound(met_, met_by.rank, {}, &std::pair<int, const Part*>::first);
  for (; met != met_.end() && met->first == met_by.rank; ++met) {
    const Part* part = met->second;
    if (part->body != &body && part->body->sheet == body.sheet) parts.push_back(part);
  }
  return parts;
}

void SheetContacts::find(std::span<const BodyPair> pairs) {
  contacts_.clear();
  list_met(pairs);
  for (const BodyPair& pair : pairs) {
    const auto [first, second] = turned(pair);
    if (!first->gives_way() || first->parts.empty() || second->parts.empty()) continue;
    const Part &one = *first->parts.front(), &other = *second->parts.front();
    if (!within_reach(box(one), box(other), 0.0) || !narrow_phase_.overlap({&one, &other})) continue;
    if (narrow_phase_.find_contact_in_plane(
            {beside(*first, *second, beside_first_), beside(*second, *first, beside_second_)}))
      contacts_.push_back({first, second, narrow_phase_.normal, narrow_phase_.patch});
  }
  // Ranks of parts in one place follow their ids, which a resumed run assigns again.
  const auto key = [](const Contact& c) {
    const Vec3 p = c.patch.points[0].position;
    return std::tuple(rank_of_sheet(*c.first), rank_of_sheet(*c.second), p.x, p.y, p.z, c.normal.x, c.normal.y,
                      c.patch.area);
  };
  std::ranges::stable_sort(contacts_, {}, key);
}

void SheetContacts::add_to(BoundedSolver& solver, double dt) {
  first_in_solver_ = contacts_.empty() ? 0 : solver.n_points();
  for (const Contact& contact : contacts_)
    solver.add(SolverContact{.first = contact.first->in_solver,
                             .second = contact.second->in_solver,
                             .normal = contact.normal,
                             .friction = law_.friction,
                             .crushing_impulse = dt * law_.crushing_pressure},
               contact.points());
}

void SheetContacts::report(const BoundedSolver& solver, double dt, std::vector<ContactLoad>& loads) const {
  loads.clear();
  std::size_t number = first_in_solver_;
  for (const Contact& contact : contacts_) {
    for (const PatchPoint& point : contact.points()) {
      const PointImpulse impulse = solver.impulse(number++);
      if (impulse.normal == 0.0 && impulse.friction == Vec3{}) continue;
      ContactLoad& load =
          loads.emplace_back(contact_load(*contact.first, *contact.second, point.position, point.position,
                                          contact.normal, impulse.normal, impulse.friction, dt));
      load.area = point.area;
      load.depth = contact.patch.depth;
      load.at_bound = impulse.at_bound;
    }
  }
}

}  // namespace brash::rigid_body
