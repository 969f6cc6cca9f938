// SPDX-License-Identifier: GPL-3.0-or-later
// One time step, as Sections 2.1 and 2.2 of the paper have it. docs/theory/simulation.md
#include "brash/core/interruption.hpp"
#include "brash/structure/motion.hpp"
#include "region_loads.hpp"
#include "stages.hpp"

namespace brash::simulation {
namespace {

/// The structure moves through level ice (Sec. 2.2.2), in as many parts as move_within_limits() asks for.
void advance_through_ice(State& s, const Laws& laws, Step& step) {
  const StageTimer::Scope clock(step.timer, step.report.times.contacts);
  expect_on_the_plane(s, laws);
  s.sheets.begin_step();
  int n_parts = 0;
  for (double done = 0.0, share = 1.0; done < 1.0; ++n_parts, share = 1.0 - done) {
    look_for_interruption();
    std::vector<edge::EdgeContact> contacts = move_within_limits(s, laws, done, share, step);
    crush_edges(s, laws, contacts, done, share, step);
    done += share;
    const std::vector<edge::EdgeContact> of_structure = s.sheets.any() ? contacts : std::vector<edge::EdgeContact>{};
    add_contacts_of_floes(s, laws, contacts);
    judge(s, laws, contacts, s.time(laws) + done * laws.resolved.time.step, step);
    break_ice(s, laws, contacts, step);
    split_sheets(s, laws, of_structure, step);
  }
  release_small_sheets(s, laws, step);
  step.report.n_substeps = n_parts;
  for (model::CrackEvent& event : step.report.events) event.substeps = n_parts;
  s.world.move_structure(s.structure_body, s.motion->now().pose, s.motion->now().twist);
}

void load_by_water(State& s, const Laws& laws, Step& step) {
  const StageTimer::Scope clock(step.timer, step.report.times.water);
  for (const BodyId body : s.world.moving()) lay_sheet_near(s, laws, body);
  laws.water.apply(s.world, s.floes, laws.resolved.time.step, {step.start, s.motion->now().twist});
}

void step_bodies(State& s, const Laws& laws, Step& step) {
  look_for_interruption();
  const StageTimer::Scope clock(step.timer, step.report.times.world);
  hand_over_sheets(s, laws);
  s.world.step(laws.resolved.time.step);
  s.sleep.notice_woken(s.world, s.floes);
  step.report.last_change = s.world.last_change();
}

/// The loads of floes on the structure and the bed, about where the structure was when their contacts were found; sheet
/// axes.
struct FloeLoads {
  Wrench normal, friction, bed;
};

FloeLoads floe_loads(const State& s, Step& step) {
  FloeLoads loads;
  for (const rigid_body::ContactLoad& contact : s.world.contacts()) {
    const Vec3 arm = contact.point - step.start.position;
    if (contact.other_kind == rigid_body::BodyKind::kBed) loads.bed += {-force(contact), cross(arm, -force(contact))};
    if (contact.other != s.structure_body) continue;
    const Vec3 normal = -contact.normal_force * contact.normal;
    const Vec3 friction = -contact.friction_force;
    loads.normal += {normal, cross(arm, normal)};
    loads.friction += {friction, cross(arm, friction)};
    step.region_loads.add_floe(step.start, contact.point, contact.normal, normal + friction);
    ++step.report.loads.n_contacts;
  }
  return loads;
}

void report_areas(const State& s, model::LoadRow& row) {
  const geometry::Ledger& ledger = s.field.ledger();
  row.area_sheet = ledger.sheet.square_metres();
  row.area_floes = ledger.floes.square_metres();
  row.area_crushed = ledger.crushed.square_metres();
  row.area_deleted = ledger.deleted.square_metres();
  row.area_brash = ledger.brash.square_metres();
  row.area_snap = ledger.snap.square_metres();
  row.n_floes = static_cast<int>(s.floes.floes().size());
}

void report_motion(const State& s, model::LoadRow& row) {
  const auto& [pose, twist] = s.motion->now();
  row.structure = plan(pose.position);
  row.velocity = plan(twist.linear);
  row.height = pose.position.z;
  row.rise = twist.linear.z;
  row.attitude = structure::attitude_of(pose.rotation);
  row.spin = twist.angular;
}

/// The load on the structure: impulse / dt of each floe contact (Sec. 2.1.3), and the crushing of the edge; and the
/// energies.
/// @return the whole load, sheet axes.
Wrench collect_loads(State& s, const Laws& laws, Step& step) {
  const StageTimer::Scope clock(step.timer, step.report.times.loads);
  look_for_interruption();
  const auto [normal, friction, bed] = floe_loads(s, step);
  Wrench total = step.crushing;
  total += normal;
  total += friction;
  const structure::State& now = s.motion->now();
  const LoadAxes in_load_axes(now.pose);
  model::LoadRow& row = step.report.loads;
  row.time = s.time(laws);
  row.crushing = in_load_axes(step.crushing);
  row.floe_normal = in_load_axes(normal);
  row.floe_friction = in_load_axes(friction);
  row.total = in_load_axes(total);
  row.bed = in_load_axes(bed);
  row.regions = step.region_loads.in(in_load_axes);
  if (laws.coverage) {
    const floes::CoveredShares covered = laws.coverage->by(s.world, s.floes, now.pose);
    for (std::size_t i = 0; i < covered.size(); ++i) row.regions[i].covered = covered[i];
  }

  const double dt = laws.resolved.time.step;
  Wrench of_floes = normal;
  of_floes += friction;
  s.energy.book_structure(step.crushing, of_floes, {-dt * now.twist.linear, -dt * now.twist.angular});
  s.energy.book_step(s.world, s.floes, step.first_newborn, dt);
  take_back_sheets(s, laws);
  s.energy.report(s.world, s.floes, row, s.sheets.kinetic_energy());
  report_areas(s, row);
  report_motion(s, row);
  return total;
}

/// Numbers that cannot be physics end the run.
void watch(State& s, Step& step) {
  const StageTimer::Scope clock(step.timer, step.report.times.loads);
  s.watchdog.look(
      {s.world, s.floes, s.energy, s.field.ledger(), step.report.loads, s.energy.taken(), s.motion->now().twist});
}

}  // namespace

// All events of a step happen at its end.
void take(Step& step, State& s, const Laws& laws) {
  step.first_newborn = s.n_steps == 0 ? 0 : s.floes.next_id();
  step.start = s.motion->now().pose;
  ++s.n_steps;
  advance_through_ice(s, laws, step);                // Sec. 2.2.2; Eqs. 15, 17 to 19
  load_by_water(s, laws, step);                      // Eqs. 13, 14
  step_bodies(s, laws, step);                        // contacts with bounded impulses; Eqs. 1 to 10, 16
  const Wrench load = collect_loads(s, laws, step);  // Sec. 2.1.3
  watch(s, step);
  fall_asleep_or_wake(s, laws, step);
  average_contacts(s, laws, step);
  remove_crushed_floes(s, laws, step);  // Sec. 2.2.1
  split_floes(s, laws, step);
  s.motion->bear(load);  // in its next motion
  step.report.loads.body = s.motion->energy();
}

}  // namespace brash::simulation
