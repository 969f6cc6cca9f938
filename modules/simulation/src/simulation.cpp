// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/simulation/simulation.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "borders.hpp"
#include "brash/simulation/scales.hpp"
#include "brash/statistics/random.hpp"
#include "brash/structure/attitude.hpp"
#include "laid_floes.hpp"
#include "load_axes.hpp"
#include "simulation_impl.hpp"

namespace brash::simulation {
namespace {

rigid_body::WorldSettings world_settings(const model::Case& c) {
  const double crushing = c.ice.compressive_strength * c.ice.crushing_factor;
  return {.ice_structure = {c.ice.friction_structure, crushing},
          .ice_ice = {c.ice.friction_ice, crushing},
          .restitution = c.contact.restitution,
          .iterations = c.contact.iterations,
          .collision_margin = c.contact.margin,
          .release_speed = c.time.settle_speed,
          .engine = c.contact.engine == model::ContactEngine::kBullet ? rigid_body::Engine::kBullet
                                                                      : rigid_body::Engine::kBrash};
}

/// Of each level ice; none where edges do not move.
std::vector<failure::EdgeDynamics> edge_dynamics(const model::Case& c, const ice::Field& field) {
  std::vector<failure::EdgeDynamics> dynamics;
  if (c.failure.edge == model::EdgeMotion::kStatic) return dynamics;
  for (const ice::Plate& plate : field.level_ice()) {
    const ice::Plate& first = field.level_ice().front();
    if (dynamics.empty())
      dynamics.push_back(failure::make_edge_dynamics(plate.ice(), c.ice.density));
    else if (plate.ice().thickness == first.ice().thickness)
      dynamics.push_back(failure::EdgeDynamics(dynamics.front()));
    else
      dynamics.push_back(dynamics.front().of_thickness(plate.ice().thickness));
  }
  return dynamics;
}

}  // namespace

Simulation::Impl::Impl(const model::Case& c, ice::Field laid, int threads)
    : resolved(c),
      hull(structure::make_hull(c.structure)),
      motion(structure::make_motion(c, *hull)),
      field(std::move(laid)),
      hull_reach(hull->reach()),
      edges(edge_dynamics(c, field)),
      verdicts(c.failure.lateness),
      pattern(ice::make_crack_pattern(c.failure)),
      workers(threads),
      world(world_settings(c)),
      borders(lay_borders(c, world)),
      sheets(resolved, world, field.level_ice().front().hold() == ice::Hold::kDrifting),
      tiles(resolved),
      floes(resolved),
      water(resolved),
      sleep(resolved),
      structure_body(world.add_structure(hull->parts(), motion->now().pose)),
      region_loads(structure::regions_of(c.structure, *hull)),
      watchdog(resolved, hull->bounds()) {
  world.share_work(workers);
  for (const ice::Plate& plate : field.level_ice()) {
    add_judge(plate);
    sheets.add(plate, {.velocity = drift_at_start(c)});
  }
}

/// Level ice of the same kind has one judge.
void Simulation::Impl::add_judge(const ice::Plate& plate) {
  for (std::size_t i = 0; i < criteria.size(); ++i) {
    const failure::IceProperties& other = field.level_ice()[i].ice();
    if (other.thickness != plate.ice().thickness || other.flexural_strength != plate.ice().flexural_strength) continue;
    criteria.push_back(std::shared_ptr(criteria[i]));
    return;
  }
  criteria.push_back(make_criterion(resolved, plate.ice()));
}

Simulation::Impl::Impl(const model::Case& c, int threads) : Impl(c, laid_field(c), threads) {
  lay_floes();
  begin_asleep();
  energy.book_drift_at_start(sheets.kinetic_energy());
  if (c.field.kind == model::FieldKind::kLevelIce && c.field.initial_crack) initial_crack();
  begin_watch();
}

void Simulation::Impl::begin_watch() {
  model::LoadRow row;
  energy.report(world, floes, row, sheets.kinetic_energy());
  double births = 0.0;
  for (const auto& [body, floe] : floes.floes()) births += floes.energy(world, body, floe);
  watchdog.begin({world, floes, energy, field.ledger(), row, {}, motion->now().twist}, births);
}

/// The load on the structure: impulse / dt of each floe contact, and the crushing of the edge; and the energies.
/// @param start     where the structure was when the contacts were found, about which they have their moments.
/// @param crushing  of the edge, sheet axes.
/// @return the whole load, sheet axes.
Wrench Simulation::Impl::collect_loads(std::int64_t first_newborn, const Pose& start, const Wrench& crushing,
                                       StepReport& report) {
  const StageTimer::Scope clock(timer, times.loads);
  model::LoadRow& row = report.loads;
  row.time = time();
  Wrench floe_normal, floe_friction;
  for (const rigid_body::ContactLoad& contact : world.contacts()) {
    if (contact.other != structure_body) continue;
    const Vec3 arm = contact.point - start.position;
    const Vec3 normal = -contact.normal_force * contact.normal;
    const Vec3 friction = -contact.friction_force;
    floe_normal += {normal, cross(arm, normal)};
    floe_friction += {friction, cross(arm, friction)};
    region_loads.add_floe(start, contact.point, contact.normal, normal + friction);
    ++row.n_contacts;
  }
  Wrench total = crushing;
  total += floe_normal;
  total += floe_friction;
  const structure::State& now = motion->now();
  const LoadAxes in_load_axes(now.pose);
  row.crushing = in_load_axes(crushing);
  row.floe_normal = in_load_axes(floe_normal);
  row.floe_friction = in_load_axes(floe_friction);
  row.total = in_load_axes(total);
  row.regions = region_loads.in(in_load_axes);
  const double dt = resolved.time.step;
  Wrench floe_load = floe_normal;
  floe_load += floe_friction;
  energy.book_structure(crushing, floe_load, {-dt * now.twist.linear, -dt * now.twist.angular});
  energy.book_step(world, floes, first_newborn, dt);
  take_back_sheets();
  energy.report(world, floes, row, sheets.kinetic_energy());

  const geometry::Ledger& ledger = field.ledger();
  row.area_sheet = ledger.sheet.square_metres();
  row.area_floes = ledger.floes.square_metres();
  row.area_crushed = ledger.crushed.square_metres();
  row.area_deleted = ledger.deleted.square_metres();
  row.area_brash = ledger.brash.square_metres();
  row.area_snap = ledger.snap.square_metres();
  row.n_floes = static_cast<int>(floes.floes().size());
  report_motion(row);
  return total;
}

void Simulation::Impl::report_motion(model::LoadRow& row) const {
  const auto& [pose, twist] = motion->now();
  row.structure = plan(pose.position);
  row.velocity = plan(twist.linear);
  row.height = pose.position.z;
  row.rise = twist.linear.z;
  row.attitude = structure::attitude_of(pose.rotation);
  row.spin = twist.angular;
}

/// @param start  where the structure was at the start of the step, as the floes are.
void Simulation::Impl::load_by_water(const Pose& start) {
  const StageTimer::Scope clock(timer, times.water);
  for (const BodyId body : world.moving()) lay_sheet_near(body);
  water.apply(world, floes, resolved.time.step, {start, motion->now().twist});
}

void Simulation::Impl::step_bodies(StepReport& report) {
  const StageTimer::Scope clock(timer, times.world);
  hand_over_sheets();
  world.step(resolved.time.step);
  sleep.notice_woken(world, floes);
  report.last_change = world.last_change();
}

/// Where floes may sleep: beyond the reach of the structure astern, and in a field of floes all around it, where the
/// water that gives way to it is slow. That falls with the cube of the distance at least; docs/theory/simulation.md,
/// (S2).
/// @param fall  whether they may fall asleep, which takes a structure's width too.
Clear Simulation::Impl::clear_of_structure(bool fall) const {
  double reach = 0.0;
  for (const structure::ConvexPart& part : hull->parts())
    for (const Vec3 v : part) reach = std::max(reach, norm(plan(v)));
  const structure::State& now = motion->now();
  const bool all_around = resolved.field.kind == model::FieldKind::kFloes;
  const bool stirs = all_around && resolved.hydrodynamics.structure_flow;
  const double speed = norm(plan(now.twist.linear) - current_past_ice(resolved));
  const double stirred = stirs ? reach * std::cbrt(speed / resolved.time.settle_speed) : 0.0;
  const double width = fall ? 2.0 * hull->displaced(now.pose).waterplane.radius : 0.0;
  return {.origin = plan(now.pose.position),
          .course = normalized(motion->course()),
          .distance = std::max({width, reach, stirred}),
          .all_around = all_around};
}

void Simulation::Impl::fall_asleep_or_wake() {
  const StageTimer::Scope clock(timer, times.loads);
  if (resolved.time.settle_speed == 0.0 || sheets.any()) return;
  sleep.wake_beyond(world, floes, clear_of_structure(false));
  energy.book_fallen_asleep(sleep.update(world, floes, clear_of_structure(true)));
}

/// A field that nothing drives rests until the structure comes.
void Simulation::Impl::begin_asleep() {
  const bool at_rest = current_past_ice(resolved) == Vec2{} && resolved.wind.velocity == Vec2{};
  if (resolved.time.settle_speed == 0.0 || sheets.any() || !at_rest) return;
  if (resolved.field.kind == model::FieldKind::kFloes) sleep.begin(world, floes, clear_of_structure(true));
}

/// Contact forces averaged over each floe's collision time: its stress, its bending, and its load on level ice.
void Simulation::Impl::average_contacts() {
  const StageTimer::Scope clock(timer, times.loads);
  const double dt = resolved.time.step;
  const auto contacts = contacts_by_place(world);
  average_stress(world, contacts, dt, floes);
  const auto in_sheet = [&](int level_ice, const rigid_body::ContactLoad& contact) {
    rigid_body::ContactLoad there = contact;
    there.point = sheets.to_sheet(level_ice, contact.point);
    there.normal = sheets.turned_back(level_ice, contact.normal);
    there.friction_force = sheets.turned_back(level_ice, contact.friction_force);
    return there;
  };
  bearings.average(
      world, floes, contacts, [&](BodyId part) { return tiles.level_ice_of(part); }, dt, in_sheet);
  if (resolved.failure.pieces == model::Pieces::kBreak) bending.average(world, floes, contacts, dt);
}

/// Floes whose mean compressive stress exceeds sigma_c are crushed and leave (Sec. 2.2.1).
void Simulation::Impl::remove_crushed_floes(StepReport& report) {
  const StageTimer::Scope clock(timer, times.loads);
  if (!resolved.contact.delete_crushed) return;
  for (const BodyId body : overstressed(world, floes, resolved.ice.compressive_strength)) {
    energy.remove(world, floes, body);
    sleep.forget(floes, body);
    bearings.forget(body);
    bending.forget(body);
    const Floe floe = floes.remove(world, body);
    watchdog.remove(body, floe.weight);
    field.to_deleted(floe.plate);
    report.deaths.push_back({floe.id, model::FloeEnd::kCrushed, floe.stress.peak_compression});
  }
}

void Simulation::Impl::watch(const StepReport& report) {
  const StageTimer::Scope clock(timer, times.loads);
  watchdog.look({world, floes, energy, field.ledger(), report.loads, energy.taken(), motion->now().twist});
}

// A step goes through these stages, each a function of the state that the one before it left. All events of a step
// happen at its end.
//
//  1. The structure moves, and sheets with free borders. Contacts with level ice: crushing, wedges, failures, cracks.
//     Eqs. 15, 17 to 19. Sheets that drift split in their plane.
//  2. Water loads the floes: weight, buoyancy, drag. Eqs. 13, 14
//  3. The bodies step: contacts with bounded impulses. Eqs. 1 to 10, 16
//  4. Loads on the structure, impulse / dt by cause, and the energies. Drifting sheets take their velocities.
//  5. The watchdog looks at floes and accounts.
//  6. Slow floes fall asleep, pushed ones wake.
//  7. Contact forces are averaged: stress and bending of the floes, and their loads on level ice in the next step.
//  8. Floes with more stress than sigma_c leave.
//  9. Floes that bend more than sigma_f allows split.
// 10. The structure bears the load in its next motion.
StepReport Simulation::Impl::step() {
  StepReport report;
  const std::int64_t first_newborn = n_steps == 0 ? 0 : floes.next_id();
  const Pose start = motion->now().pose;
  ++n_steps;
  const Wrench crushing = advance_through_ice(report);
  load_by_water(start);
  step_bodies(report);
  const Wrench load = collect_loads(first_newborn, start, crushing, report);
  watch(report);
  fall_asleep_or_wake();
  average_contacts();
  remove_crushed_floes(report);
  split_floes(report);
  motion->bear(load);
  report.loads.body = motion->energy();
  return report;
}

Simulation::Simulation(const model::Case& resolved, int threads) : impl_(std::make_unique<Impl>(resolved, threads)) {}
Simulation::Simulation(const model::Case& resolved, const model::Checkpoint& checkpoint, int threads)
    : impl_(std::make_unique<Impl>(resolved, checkpoint, threads)) {}
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

void Simulation::drive(const structure::State& goal) { impl_->motion->drive(goal); }
void Simulation::drive(const Pose& goal) {
  impl_->motion->drive(structure::way_to(goal, impl_->motion->now().pose, impl_->resolved.time.step));
}
void Simulation::drive(const Twist& twist) {
  impl_->motion->drive(structure::way_at(twist, impl_->motion->now().pose, impl_->resolved.time.step));
}
const structure::State& Simulation::structure() const { return impl_->motion->now(); }
StepReport Simulation::step() { return impl_->step(); }
model::Checkpoint Simulation::checkpoint() const { return impl_->checkpoint(); }
double Simulation::time() const { return impl_->time(); }
const std::vector<model::FloeRecord>& Simulation::initial_births() const { return impl_->initial_births; }
std::vector<geometry::Polygon> Simulation::sheet() const { return impl_->outlines_in_world(); }
std::vector<SheetMotion> Simulation::sheet_motions() const { return impl_->sheets.motions(); }
const geometry::Ledger& Simulation::ledger() const { return impl_->field.ledger(); }
const StageTimes& Simulation::stage_times() const { return impl_->times; }
std::vector<model::Warning> Simulation::warnings() const { return derived_scales(impl_->resolved).warnings; }

std::vector<std::pair<std::int64_t, double>> Simulation::peak_stresses() const {
  std::vector<std::pair<std::int64_t, double>> stresses;
  for (const auto& [body, floe] : impl_->floes.floes()) stresses.emplace_back(floe.id, floe.stress.peak_compression);
  return stresses;
}

model::Frame Simulation::frame() const {
  model::Frame frame{.time = time(), .structure = impl_->motion->now().pose, .floes = {}};
  std::vector<std::pair<BodyId, double>> forces;
  for (const rigid_body::ContactLoad& contact : impl_->world.contacts()) {
    if (contact.normal_force == 0.0) continue;
    forces.emplace_back(contact.body, contact.normal_force);
    forces.emplace_back(contact.other, contact.normal_force);
  }
  // Summed in the order of their sizes: the order of the contacts names tiles of the sheet, which a resumed run lays
  // again.
  std::ranges::sort(forces);
  for (const auto& [body, floe] : impl_->floes.floes()) {
    double sum = 0.0;
    auto force = std::ranges::lower_bound(forces, body, {}, &std::pair<BodyId, double>::first);
    for (; force != forces.end() && force->first == body; ++force) sum += force->second;
    frame.floes.push_back({floe.id, impl_->world.pose(body), sum});
  }
  return frame;
}

}  // namespace brash::simulation
