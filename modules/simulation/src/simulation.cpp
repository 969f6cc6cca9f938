// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/simulation/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "brash/simulation/cone_of.hpp"
#include "brash/simulation/scales.hpp"
#include "brash/statistics/random.hpp"
#include "initial_crack.hpp"
#include "plan.hpp"
#include "simulation_impl.hpp"

namespace brash::simulation {
namespace {

rigid_body::WorldSettings world_settings(const model::Case& c) {
  const double crushing = c.ice.compressive_strength * c.ice.crushing_factor;
  return {.ice_structure = {c.ice.friction_structure, c.contact.restitution, crushing},
          .ice_ice = {c.ice.friction_ice, c.contact.restitution, crushing},
          .iterations = c.contact.iterations,
          .collision_margin = c.contact.margin,
          .release_speed = c.time.settle_speed};
}

/// World axes to load axes: x as the ice drifts against the structure, z upwards (a half turn about z).
Wrench in_load_axes(const Wrench& w) {
  return {{-w.force.x, -w.force.y, w.force.z}, {-w.moment.x, -w.moment.y, w.moment.z}};
}

void count_range(const failure::Assessment& assessment, StepReport& report) {
  report.n_above_range += assessment.above_range ? 1 : 0;
  report.n_below_range += assessment.below_range ? 1 : 0;
  report.n_outlines_refused += assessment.outline_refused ? 1 : 0;
}

/// A criterion whose time is booked to the stage `failure`.
class TimedCriterion final : public failure::BendingCriterion {
 public:
  TimedCriterion(std::unique_ptr<failure::BendingCriterion> criterion, StageTimer& timer, double& seconds)
      : criterion_(std::move(criterion)), timer_(timer), seconds_(seconds) {}

  failure::Assessment assess(const failure::LoadCase& load) const override {
    const StageTimer::Scope clock(timer_, seconds_);
    return criterion_->assess(load);
  }
  std::optional<failure::Assessment> dismiss(const failure::LoadCase& load) const override {
    const StageTimer::Scope clock(timer_, seconds_);
    return criterion_->dismiss(load);
  }
  bool needs_outline() const override { return criterion_->needs_outline(); }

 private:
  std::unique_ptr<failure::BendingCriterion> criterion_;
  StageTimer& timer_;
  double& seconds_;
};

}  // namespace

Simulation::Impl::Impl(const model::Case& c, IceField laid)
    : resolved(c),
      ice(ice_properties(c)),
      cone(cone_of(c)),
      criterion(std::make_unique<TimedCriterion>(make_criterion(c, ice), timer, times.failure)),
      field(std::move(laid)),
      world(world_settings(c)),
      tiles(freeboard(c).bottom, freeboard(c).top),
      floes(resolved),
      centre{-c.structure.start_distance, 0.0},
      watchdog(resolved) {
  const std::vector<Vec3> hull = structure::hull(cone);
  structure_body = world.add_structure(std::span(&hull, 1), structure_pose());
}

Simulation::Impl::Impl(const model::Case& c) : Impl(c, IceField(c.field.length, c.field.width)) {
  if (c.field.initial_crack) initial_crack();
  begin_watch();
}

void Simulation::Impl::begin_watch() {
  model::LoadRow row;
  energy.report(world, floes, row);
  watchdog.begin({world, floes, energy, field.ledger(), row, {}});
}

/// The paper takes 3 to 5 wedges at random (after Nevel); one stream a break, so that a resumed run draws the same.
int Simulation::Impl::draw_wedges() {
  statistics::RandomStream stream(resolved.random.seed, resolved.name, resolved.random.replicate, "wedges", n_breaks++);
  return stream.uniform_int(resolved.failure.wedges[0], resolved.failure.wedges[1]);
}

void Simulation::Impl::initial_crack() {
  StepReport report;
  initial_births = break_off({0.0, 0.0}, initial_crack_radius(resolved, ice, *criterion), draw_wedges(), report);
}

/// One circumferential crack with its radial cracks: sheet, floes and collision shapes follow.
std::vector<model::FloeRecord> Simulation::Impl::break_off(Vec2 at, double radius, int n_wedges, StepReport& report) {
  const StageTimer::Scope clock(timer, times.cutting);
  const geometry::Ring section = leading_section(edge_model(), centre);
  floes.sheet_broke(world, at, radius);
  const Broken broken =
      field.break_free(at, radius, n_wedges, resolved.failure.arc_sides, section, resolved.failure.smallest_floe);
  std::vector<model::FloeRecord> births;
  for (const geometry::Polygon& piece : broken.floes) {
    std::optional<model::FloeRecord> record = floes.add(world, piece, time());
    if (!record) {
      field.floe_to_brash(geometry::area(piece));
      continue;
    }
    const double mass = resolved.ice.density * ice.thickness * record->area;
    if (collision_time(resolved, mass) < resolved.time.step) ++report.n_steps_too_long;
    births.push_back(std::move(*record));
  }
  tiles.renew(field.sheet(), world, broken.changed);
  return births;
}

/// Moves the structure by the largest part of `share` of the step whose contacts stay below the failure model's upper
/// range (Sec. 2.2.2: "a shorter time step can avoid it"); `share` becomes that part. It cannot where a contact is
/// above already: the step is then left whole. What the trailing section then covers is crushed, so the contacts are
/// those of the state that is reached, however short or long the step.
std::vector<EdgeContact> Simulation::Impl::move_within_range(double& share, StepReport& report) {
  const double shortest = 1.0 / resolved.failure.max_substeps;
  const Vec2 whole_step{resolved.structure.speed * resolved.time.step, 0.0};
  const auto contacts_after = [&](double part) {
    return edge_contacts(edge_model(), field.sheet(), centre + part * whole_step);
  };
  const auto above_range = [](const std::vector<EdgeContact>& contacts) {
    return std::ranges::any_of(contacts, [](const EdgeContact& c) { return c.assessment.above_range; });
  };
  std::vector<EdgeContact> contacts = contacts_after(share);
  if (0.5 * share >= shortest && above_range(contacts) && !above_range(contacts_after(0.0))) {
    do {
      share *= 0.5;
      contacts = contacts_after(share);
    } while (0.5 * share >= shortest && above_range(contacts));
  }

  centre += share * whole_step;
  if (crush_passed_ice()) contacts = edge_contacts(edge_model(), field.sheet(), centre);
  for (const EdgeContact& contact : contacts) count_range(contact.assessment, report);
  return contacts;
}

/// The sheet's edge under the floes that press on it, by their forces up to the step before. In the order of the floes.
std::vector<EdgeContact> Simulation::Impl::contacts_of_floes(StepReport& report) const {
  std::vector<EdgeContact> contacts;
  if (!resolved.failure.under_floes) return contacts;
  for (const BodyId body : world.moving()) {
    const Floe& floe = floes.at(body);
    auto contact = bearing_contact(edge_model(), field.sheet(), floe.id, floe.bearing);
    if (!contact) continue;
    count_range(contact->assessment, report);
    contacts.push_back(std::move(*contact));
  }
  return contacts;
}

/// What the trailing section covers has been penetrated through the whole thickness: it is crushed and leaves the
/// sheet. @return whether there was any.
bool Simulation::Impl::crush_passed_ice() {
  const StageTimer::Scope clock(timer, times.cutting);
  const geometry::Extent changed = field.crush(trailing_section(edge_model(), centre));
  tiles.renew(field.sheet(), world, changed);
  return !changed.is_empty();
}

/// Breaks the ice at every contact whose stress exceeds the flexural strength, in the contacts' order; a contact whose
/// ice an earlier one has just broken off is left to the next step.
void Simulation::Impl::break_ice(const std::vector<EdgeContact>& contacts, StepReport& report) {
  for (const EdgeContact& contact : contacts) {
    const bool broken_off = std::ranges::any_of(report.events, [&](const model::CrackEvent& event) {
      return norm(event.at - contact.region.midpoint) < event.breaking_length;
    });
    if (!contact.assessment.fails || broken_off) continue;
    const int n_wedges = draw_wedges();
    model::CrackEvent event{.time = time(),
                            .at = contact.region.midpoint,
                            .depth = contact.wedge.depth,
                            .contact_length = contact.region.contact_length,
                            .angle = contact.wedge.angle,
                            .fit_error = contact.wedge.error,
                            .mu1 = contact.load.mu1,
                            .mu2 = contact.load.mu2,
                            .pressure = contact.load.pressure,
                            .sigma_max = contact.assessment.sigma_max,
                            .breaking_length = contact.assessment.breaking_length,
                            .wedges = n_wedges,
                            .in_range = !contact.assessment.below_range && !contact.assessment.above_range,
                            .area_before = field.ledger().sheet.square_metres(),
                            .tip = 0.5 * (contact.region.chord_from + contact.region.chord_to),
                            .towards = contact.region.normal,
                            .pressing_floe = contact.floe};
    std::vector<model::FloeRecord> births =
        break_off(contact.region.midpoint, contact.assessment.breaking_length, n_wedges, report);
    event.pieces = static_cast<int>(births.size());
    event.area_after = field.ledger().sheet.square_metres();
    report.events.push_back(event);
    std::ranges::move(births, std::back_inserter(report.births));
  }
}

/// Moves the structure through one step: contacts, crushing, wedges, failures and cracks, in as many parts as the
/// failure model's range asks for. The crushing load is the mean over the parts.
void Simulation::Impl::advance_through_ice(StepReport& report) {
  const StageTimer::Scope clock(timer, times.contacts);
  double done = 0.0;
  for (report.n_substeps = 1; done < 1.0; ++report.n_substeps) {
    double share = 1.0 - done;
    const std::vector<EdgeContact> contacts = move_within_range(share, report);
    done += share;
    for (const EdgeContact& contact : contacts) {
      const Vec3 arm = contact.point - structure_pose().position;
      report.loads.crushing += in_load_axes({share * contact.force, share * cross(arm, contact.force)});
    }
    break_ice(contacts, report);
  }
  --report.n_substeps;
  break_ice(contacts_of_floes(report), report);
  for (model::CrackEvent& event : report.events) event.substeps = report.n_substeps;
  world.move_structure(structure_body, structure_pose(), {{resolved.structure.speed, 0.0, 0.0}, {}});
}

/// Floes whose mean compressive stress exceeds sigma_c are crushed and leave (Sec. 2.2.1).
void Simulation::Impl::remove_crushed_floes(StepReport& report) {
  floes.average_contacts(world, resolved.time.step);
  if (!resolved.contact.delete_crushed) return;
  for (const BodyId body : floes.overstressed(world, resolved.ice.compressive_strength)) {
    energy.remove(world, floes, body);
    const Floe floe = floes.remove(world, body);
    field.floe_to_deleted(floe.area);
    report.deaths.push_back({floe.id, model::FloeEnd::kCrushed, floe.peak_compression});
  }
}

/// The load on the structure: impulse / dt of each floe contact, and the crushing of the edge; and the energies.
/// @param origin  where the structure was when the contacts were found, about which they have their moments [m].
void Simulation::Impl::collect_loads(std::int64_t first_newborn, Vec3 origin, StepReport& report) {
  const StageTimer::Scope clock(timer, times.loads);
  model::LoadRow& row = report.loads;
  row.time = time();
  for (const rigid_body::ContactLoad& contact : world.contacts()) {
    if (contact.other != structure_body) continue;
    const Vec3 arm = contact.point - origin;
    const Vec3 normal = -contact.normal_force * contact.normal;
    const Vec3 friction = -contact.friction_force;
    row.floe_normal += in_load_axes({normal, cross(arm, normal)});
    row.floe_friction += in_load_axes({friction, cross(arm, friction)});
    ++row.n_contacts;
  }
  row.total = row.crushing;
  row.total += row.floe_normal;
  row.total += row.floe_friction;
  const double dt = resolved.time.step;
  energy.book_structure(row.crushing.force.x, row.floe_normal.force.x + row.floe_friction.force.x,
                        resolved.structure.speed * dt);
  energy.book_step(world, floes, first_newborn, dt);
  energy.report(world, floes, row);

  const geometry::Ledger& ledger = field.ledger();
  row.area_sheet = ledger.sheet.square_metres();
  row.area_floes = ledger.floes.square_metres();
  row.area_crushed = ledger.crushed.square_metres();
  row.area_deleted = ledger.deleted.square_metres();
  row.area_brash = ledger.brash.square_metres();
  row.area_snap = ledger.snap.square_metres();
  row.n_floes = static_cast<int>(floes.floes().size());
}

/// The sheet's collision shapes wherever the floe could meet them, or be in the lee of them, in this step.
void Simulation::Impl::lay_sheet_near(BodyId body) {
  const Vec2 reach{floes.reach(), floes.reach()};
  const auto [lower, upper] = world.bounds(body);
  tiles.lay(field.sheet(), world, Vec2{lower.x, lower.y} - reach, Vec2{upper.x, upper.y} + reach);
}

StepReport Simulation::Impl::step() {
  StepReport report;
  const std::int64_t first_newborn = n_steps == 0 ? 0 : floes.next_id();
  const Vec3 origin = structure_pose().position;
  ++n_steps;                    // what happens in a step happens at its end
  advance_through_ice(report);  // the structure moves; contacts, crushing, wedges, failures, cracks: Eqs. 15, 17 to 19
  {
    const StageTimer::Scope clock(timer, times.water);
    for (const BodyId body : world.moving()) lay_sheet_near(body);
    floes.apply_water(world, resolved.time.step, centre);  // weight, buoyancy, drag: Eqs. 13, 14
  }
  {
    const StageTimer::Scope clock(timer, times.world);
    world.step(resolved.time.step);  // contacts with bounded impulses: Eqs. 1 to 10, 16
    floes.notice_let_go(world);
    report.last_change = world.last_change();
  }
  collect_loads(first_newborn, origin, report);  // impulse / dt, by cause; energies
  {
    const StageTimer::Scope clock(timer, times.loads);
    watchdog.look({world, floes, energy, field.ledger(), report.loads, energy.taken()});
    energy.book_settled(floes.settle(world, centre.x - cone.waterline_width));
    remove_crushed_floes(report);  // sigma > sigma_c
  }
  return report;
}

Simulation::Simulation(const model::Case& resolved) : impl_(std::make_unique<Impl>(resolved)) {}
Simulation::Simulation(const model::Case& resolved, const model::Checkpoint& checkpoint)
    : impl_(std::make_unique<Impl>(resolved, checkpoint)) {}
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

StepReport Simulation::step() { return impl_->step(); }
model::Checkpoint Simulation::checkpoint() const { return impl_->checkpoint(); }
double Simulation::time() const { return impl_->time(); }
const std::vector<model::FloeRecord>& Simulation::initial_births() const { return impl_->initial_births; }
std::vector<geometry::Polygon> Simulation::sheet() const { return impl_->field.sheet().polygons(); }
const geometry::Ledger& Simulation::ledger() const { return impl_->field.ledger(); }
const StageTimes& Simulation::stage_times() const { return impl_->times; }

std::vector<std::pair<std::int64_t, double>> Simulation::peak_stresses() const {
  std::vector<std::pair<std::int64_t, double>> stresses;
  for (const auto& [body, floe] : impl_->floes.floes()) stresses.emplace_back(floe.id, floe.peak_compression);
  return stresses;
}

model::Frame Simulation::frame() const {
  model::Frame frame{.time = time(), .structure = impl_->structure_pose(), .floes = {}};
  std::vector<std::pair<BodyId, double>> forces;
  for (const rigid_body::ContactLoad& contact : impl_->world.contacts()) {
    if (contact.normal_force == 0.0) continue;
    forces.emplace_back(contact.body, contact.normal_force);
    forces.emplace_back(contact.other, contact.normal_force);
  }
  // Summed in the order of their sizes: that of the contacts names tiles of the sheet, which a resumed run lays anew.
  std::ranges::sort(forces);
  for (const auto& [body, floe] : impl_->floes.floes()) {
    double sum = 0.0;
    for (const auto& [pushed, force] : std::ranges::equal_range(forces, body, {}, &std::pair<BodyId, double>::first))
      sum += force;
    frame.floes.push_back({floe.id, impl_->world.pose(body), sum});
  }
  return frame;
}

}  // namespace brash::simulation
