// SPDX-License-Identifier: GPL-3.0-or-later
// Floes are laid, sleep, are crushed and split.
#include <algorithm>
#include <cmath>
#include <utility>

#include "brash/core/interruption.hpp"
#include "brash/simulation/setup.hpp"
#include "laid_floes.hpp"
#include "stages.hpp"

namespace brash::simulation {
namespace {

/// Where floes may sleep: beyond the reach of the structure astern, and in a field of floes all around it, where the
/// water that gives way to it is slow. That falls with the cube of the distance at least; docs/theory/simulation.md,
/// (S2).
/// @param fall  whether they may fall asleep, which takes a structure's width too.
floes::Clear clear_of_structure(const State& s, const Laws& laws, bool fall) {
  const model::Case& c = laws.resolved;
  double reach = 0.0;
  for (const structure::ConvexPart& part : laws.hull->parts())
    for (const Vec3 v : part) reach = std::max(reach, norm(plan(v)));
  const structure::State& now = s.motion->now();
  const bool all_around = c.field.kind == model::FieldKind::kFloes;
  const bool stirs = all_around && c.hydrodynamics.structure_flow;
  const double speed = norm(plan(now.twist.linear) - current_past_ice(c));
  const double stirred = stirs ? reach * std::cbrt(speed / c.time.settle_speed) : 0.0;
  const double width = fall ? 2.0 * laws.hull->displaced(now.pose).waterplane.radius : 0.0;
  return {.origin = plan(now.pose.position),
          .course = normalized(s.motion->course()),
          .distance = std::max({width, reach, stirred}),
          .all_around = all_around};
}

bool may_sleep(const State& s, const Laws& laws) { return laws.resolved.time.settle_speed > 0.0 && !s.sheets.any(); }

/// A floe no longer exists: everything that keeps data of it drops it. The watchdog keeps its account, for its pieces.
floes::Floe take_out(State& s, BodyId body) {
  s.energy.remove(s.world, s.floes, body);
  s.sleep.forget(s.floes, body);
  s.bearings.forget(body);
  s.bending.forget(body);
  return s.floes.remove(s.world, body);
}

/// A floe splits in a section. Its pieces move on as it did, so mass, momentum and energy stay with them, but for
/// pieces too small for a body.
void split(State& s, const Laws& laws, const floes::Fracture& fracture, StepReport& report) {
  const BodyId body = fracture.body;
  const Pose pose = s.world.pose(body);
  const Twist twist = s.world.twist(body);
  const floes::Floe parent = take_out(s, body);
  report.deaths.push_back({parent.id, model::FloeEnd::kBroken, parent.stress.peak_compression});

  const auto in_plate = [&](double along) {
    const floes::Section& section = fracture.section;
    const Vec2 place = section.offset * section.normal + along * perpendicular(section.normal);
    return plan(to_world(parent.laid, {place.x, place.y, 0.0}));
  };
  for (ice::Plate& piece :
       s.field.split(parent.plate, in_plate(-1.0), in_plate(1.0), laws.resolved.failure.smallest_floe)) {
    auto record = s.floes.add_piece(s.world, std::move(piece), parent, pose, twist, s.time(laws));
    if (!record) {
      s.field.to_brash(piece);
      continue;
    }
    const BodyId born = s.world.floes().back();
    s.energy.add_piece(s.world, s.floes, born);
    s.watchdog.add_piece(s.floes.energy(s.world, born, s.floes.at(born)), born, body);
    if (s.floes.at(born).collision_time < laws.resolved.time.step) ++report.n_steps_too_long;
    report.births.push_back(std::move(*record));
  }
  s.watchdog.remove(body, parent.weight);
}

}  // namespace

std::vector<model::FloeRecord> lay_floes(State& s, const Laws& laws) {
  std::vector<model::FloeRecord> births;
  const bool of_field = laws.resolved.field.kind == model::FieldKind::kFloes;
  const Vec2 velocity = drift_at_start(laws.resolved);
  const structure::State drift{{}, {{velocity.x, velocity.y, 0.0}, {}}};
  for (ice::Plate& plate : floes_beside(laws.resolved, *laws.hull, s.field)) {
    s.field.add_floe(plate);
    if (!of_field && plate.area().square_metres() < laws.resolved.failure.smallest_floe) {
      s.field.to_brash(plate);
      continue;
    }
    auto record = s.floes.add(s.world, std::move(plate), 0.0, drift);
    if (record)
      births.push_back(std::move(*record));
    else
      s.field.to_brash(plate);
  }
  return births;
}

void begin_asleep(State& s, const Laws& laws) {
  const model::Case& c = laws.resolved;
  const bool at_rest = current_past_ice(c) == Vec2{} && c.wind.velocity == Vec2{};
  if (!may_sleep(s, laws) || !at_rest || c.field.kind != model::FieldKind::kFloes) return;
  s.sleep.begin(s.world, s.floes, clear_of_structure(s, laws, true));
}

void fall_asleep_or_wake(State& s, const Laws& laws, Step& step) {
  const StageTimer::Scope clock(step.timer, step.report.times.loads);
  if (!may_sleep(s, laws)) return;
  s.sleep.wake_beyond(s.world, s.floes, clear_of_structure(s, laws, false));
  s.energy.book_fallen_asleep(s.sleep.update(s.world, s.floes, clear_of_structure(s, laws, true)));
}

void average_contacts(State& s, const Laws& laws, Step& step) {
  const StageTimer::Scope clock(step.timer, step.report.times.loads);
  const double dt = laws.resolved.time.step;
  const auto contacts = floes::contacts_by_place(s.world);
  floes::update_stress(s.world, contacts, laws.stress, dt, s.floes);
  const auto level_ice_of = [&](BodyId part) { return s.tiles.level_ice_of(part); };
  const auto in_sheet = [&](int level_ice, const rigid_body::ContactLoad& contact) {
    rigid_body::ContactLoad there = contact;
    there.point = s.sheets.to_sheet(level_ice, contact.point);
    there.normal = s.sheets.turned_back(level_ice, contact.normal);
    there.friction_force = s.sheets.turned_back(level_ice, contact.friction_force);
    return there;
  };
  s.bearings.average(s.world, s.floes, contacts, level_ice_of, dt, in_sheet);
  if (laws.resolved.failure.pieces == model::Pieces::kBreak) s.bending.average(s.world, s.floes, contacts, dt);
}

void remove_crushed_floes(State& s, const Laws& laws, Step& step) {
  const StageTimer::Scope clock(step.timer, step.report.times.loads);
  for (const BodyId body : floes::overstressed(s.world, s.floes, laws.resolved.ice.compressive_strength)) {
    const floes::Floe floe = take_out(s, body);
    s.watchdog.remove(body, floe.weight);
    s.field.to_deleted(floe.plate);
    step.report.deaths.push_back({floe.id, model::FloeEnd::kCrushed, floe.stress.peak_compression});
  }
}

void split_floes(State& s, const Laws& laws, Step& step) {
  if (laws.resolved.failure.pieces == model::Pieces::kWhole) return;
  const StageTimer::Scope clock(step.timer, step.report.times.cutting);
  for (const floes::Fracture& fracture : s.bending.fractures(s.floes)) {
    look_for_interruption();
    split(s, laws, fracture, step.report);
  }
}

}  // namespace brash::simulation
