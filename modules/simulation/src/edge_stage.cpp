// SPDX-License-Identifier: GPL-3.0-or-later
// Structure and floes load the edge of level ice, which moves, is crushed, and gets its verdicts.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "brash/core/error.hpp"
#include "brash/core/interruption.hpp"
#include "brash/edge/local_ice.hpp"
#include "stages.hpp"

namespace brash::simulation {
namespace {

/// A part of a step ends where the ice is expected to have just failed, if the whole part would go too far; overload of
/// the most overloaded contact.
constexpr double kTooFar = 1.05, kJustFailed = 1.02;
/// The overload grows almost evenly within a step.
constexpr int kTries = 2;

void count_range(const failure::Assessment& assessment, StepReport& report) {
  report.n_above_range += assessment.above_range ? 1 : 0;
  report.n_below_range += assessment.below_range ? 1 : 0;
  report.sheets += assessment.solves;
}

/// Calls `use(plate, contacts with it)` for each level ice; the contacts are sorted by it then.
template <class Use>
void for_each_sheet(const State& s, std::vector<edge::EdgeContact>& contacts, const Use& use) {
  std::vector<edge::EdgeContact> sorted;
  for (const ice::Plate& plate : s.field.level_ice()) {
    std::vector<edge::EdgeContact> here;
    for (edge::EdgeContact& contact : contacts)
      if (contact.level_ice == plate.level_ice()) here.push_back(std::move(contact));
    std::erase_if(contacts, [&](const edge::EdgeContact& contact) { return contact.level_ice == plate.level_ice(); });
    use(plate, here);
    std::ranges::move(here, std::back_inserter(sorted));
  }
  contacts = std::move(sorted);
}

/// Every contact of the structure with level ice, were the structure in `state` at `time`; without a verdict.
/// @param later  how long the sheets drift on until then [s].
std::vector<edge::EdgeContact> contacts_at(const State& s, const Laws& laws, const structure::State& state,
                                           double later, double time) {
  std::vector<edge::EdgeContact> contacts;
  for (const ice::Plate& plate : s.field.level_ice()) {
    const auto shift = [&](const edge::Touch& touched) { return s.edges.shift(plate.level_ice(), touched, time); };
    const structure::State seen = s.sheets.seen_from(plate.level_ice(), state, later);
    if (!is_near(s, laws, plate, seen)) continue;
    for (edge::EdgeContact& contact : edge::edge_contacts(edge_model(s, laws, plate), plate.sheet(), seen, shift)) {
      contact.level_ice = plate.level_ice();
      contacts.push_back(std::move(contact));
    }
  }
  return contacts;
}

bool is_above_range(const State& s, const Laws& laws, const std::vector<edge::EdgeContact>& contacts) {
  return std::ranges::any_of(contacts, [&](const edge::EdgeContact& contact) {
    const edge::EdgeModel sheet = edge_model(s, laws, s.field.level_ice()[static_cast<std::size_t>(contact.level_ice)]);
    return contact.load.pressure > 0.0 && edge::LocalIce(sheet, contact).model().criterion.above_range(contact.load);
  });
}

void weigh_loads(const State& s, const Laws& laws, std::vector<edge::EdgeContact>& contacts) {
  for_each_sheet(s, contacts, [&](const ice::Plate& plate, std::vector<edge::EdgeContact>& here) {
    edge::weigh_loads(edge_model(s, laws, plate), here);
  });
}

/// Work of the structure on the ice of each contact in a time [s], while its sheet drifts [J].
std::vector<double> work_on(const State& s, const std::vector<edge::EdgeContact>& contacts, double seconds) {
  std::vector<double> work;
  for (const edge::EdgeContact& contact : contacts) {
    const structure::State seen = s.sheets.seen_from(contact.level_ice, s.motion->now());
    work.push_back(seconds * dot(contact.on_ice, velocity_at(seen.twist, contact.point - seen.pose.position)));
  }
  return work;
}

}  // namespace

edge::EdgeModel edge_model(const State& s, const Laws& laws, const ice::Plate& plate) {
  const ice::Variation& variation = s.field.variation();
  return {*laws.hull, laws.resolved, plate.ice(), *s.criteria[static_cast<std::size_t>(plate.level_ice())],
          variation ? &variation : nullptr};
}

void expect_on_the_plane(const State& s, const Laws& laws) {
  const Vec3 then = s.motion->after(1.0).pose.position;
  const double farthest = geometry::kMaxCoordinate - laws.hull_reach;
  if (std::abs(then.x) <= farthest && std::abs(then.y) <= farthest && std::abs(then.z) <= farthest) return;
  throw RunError(fmt::format("the structure goes to ({:.6g}, {:.6g}, {:.6g}) m, beyond the plane of the ice", then.x,
                             then.y, then.z));
}

std::vector<edge::EdgeContact> move_within_limits(State& s, const Laws& laws, double done, double& share, Step& step) {
  // Parts of a step in which an input leaves the model's range or the outlined sheet breaks; the paper gives no limit.
  constexpr double shortest = 1.0 / 8.0;
  const double dt = laws.resolved.time.step;
  const auto time_after = [&](double part) { return s.time(laws) + (done + part) * dt; };
  const auto contacts_after = [&](double part) {
    return contacts_at(s, laws, s.motion->after(part), part * dt, time_after(part));
  };
  const auto above_range = [&](const std::vector<edge::EdgeContact>& contacts) {
    return is_above_range(s, laws, contacts);
  };
  std::vector<edge::EdgeContact> contacts = contacts_after(share);
  if (0.5 * share >= shortest && above_range(contacts) && !above_range(contacts_after(0.0))) {
    do {
      share *= 0.5;
      contacts = contacts_after(share);
    } while (0.5 * share >= shortest && above_range(contacts));
  }

  for (int i = 0; i < kTries && share > shortest; ++i) {
    weigh_loads(s, laws, contacts);
    const auto growth = s.verdicts.most_overloaded(contacts);
    if (!growth || growth->now <= kTooFar) break;
    const double part = (kJustFailed - growth->before) / (growth->now - growth->before);
    share = std::max(shortest, part * share);
    contacts = contacts_after(share);
  }

  s.motion->advance(share);
  s.sheets.advance(share * dt);
  if (crush_passed_ice(s, laws, time_after(share), step))
    contacts = contacts_at(s, laws, s.motion->now(), 0.0, time_after(share));
  return contacts;
}

void crush_edges(State& s, const Laws& laws, std::vector<edge::EdgeContact>& contacts, double done, double share,
                 Step& step) {
  const double dt = laws.resolved.time.step;
  const std::vector<double> work = work_on(s, contacts, share * dt);
  s.energy.book_bent_edges(
      s.edges.follow(contacts, work, s.time(laws) + done * dt, s.time(laws) + (done + share) * dt));
  const Pose& structure = s.motion->now().pose;
  for (const edge::EdgeContact& contact : contacts) {
    const Vec3 point = s.sheets.to_world(contact.level_ice, contact.point);
    const Vec3 force = -s.sheets.turned(contact.level_ice, contact.on_ice);
    const Vec3 arm = point - structure.position;
    step.crushing += {share * force, share * cross(arm, force)};
    s.sheets.push(contact.level_ice, -share * force, point);
    const Vec3 normal = s.sheets.turned(contact.level_ice, contact.normal);
    step.region_loads.add_crushing(structure, point, normal, share * force);
  }
}

void add_contacts_of_floes(const State& s, const Laws& laws, std::vector<edge::EdgeContact>& contacts) {
  if (!laws.resolved.failure.under_floes) return;
  for (const auto& [pair, bearing] : s.bearings.all()) {
    const auto& [body, level_ice] = pair;
    const ice::Plate& plate = s.field.level_ice()[static_cast<std::size_t>(level_ice)];
    auto contact = edge::bearing_contact(edge_model(s, laws, plate), plate.sheet(), s.floes.at(body).id, bearing);
    if (!contact) continue;
    contact->level_ice = level_ice;
    contacts.push_back(std::move(*contact));
  }
}

void judge(State& s, const Laws& laws, std::vector<edge::EdgeContact>& contacts, double now, Step& step) {
  const auto motion_of = [&](const edge::EdgeContact& contact) { return s.edges.motion(contact); };
  const auto share_out = [&](std::size_t n, const auto& judge_one) {
    const StageTimer::Scope clock(step.timer, step.report.times.failure);
    s.world.workers().each(n, 1, judge_one);
  };
  for_each_sheet(s, contacts, [&](const ice::Plate& plate, std::vector<edge::EdgeContact>& here) {
    edge::weigh_loads(edge_model(s, laws, plate), here);
    for (edge::EdgeContact& contact : here)
      if (const auto life = s.edges.life(contact)) contact.edge_age = life->age;
    s.verdicts.recall(now, here);
    look_for_interruption();
    edge::assess(edge_model(s, laws, plate), plate.sheet(), here, motion_of, share_out);
  });
  for (const edge::EdgeContact& contact : contacts) count_range(contact.assessment, step.report);
  step.report.verdicts += s.verdicts.keep(now, contacts);
  if (laws.resolved.failure.joint_loads)
    std::ranges::stable_sort(contacts, std::greater{},
                             [](const edge::EdgeContact& c) { return c.assessment.sigma_max; });
}

}  // namespace brash::simulation
