// SPDX-License-Identifier: GPL-3.0-or-later
// Level ice breaks, is crushed, and becomes floes.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "brash/core/interruption.hpp"
#include "brash/floes/plan.hpp"
#include "brash/simulation/setup.hpp"
#include "brash/statistics/random.hpp"
#include "stages.hpp"

namespace brash::simulation {
namespace {

/// The free edge matters this far from a contact, in characteristic lengths.
constexpr double kEdgeReach = 3.0;

/// The result of a break.
struct Break {
  int n_wedges = 0;
  bool along_stress = false;
  std::vector<model::FloeRecord> births;
};

/// How far along the ice edge, x = 0, the way of a point of the structure meets it [m]; none if it misses the sheet.
std::optional<double> meets_edge(Vec2 from, Vec2 course, double width) {
  if (from.x > 0.0 || course.x <= 0.0) return {};
  const double y = from.y - from.x * (course.y / course.x);
  if (std::abs(y) >= 0.5 * width) return {};
  return y;
}

/// Level ice in a box has come loose: floes there press no more, and floes around it wake.
void let_go(State& s, int level_ice, const geometry::Extent& box) {
  s.bearings.forget_within(level_ice, box);
  s.edges.forget_within(level_ice, box);
  s.verdicts.forget_within(level_ice, box);
  const Vec2 to_corner = 0.5 * (box.upper - box.lower);
  s.sleep.wake_within(s.world, s.floes, box.lower + to_corner, norm(to_corner));
}

/// Level ice breaks at a contact: pressures there are forgotten, and floes around it wake.
void forget_broken(State& s, const ice::Plate& plate, const edge::EdgeContact& contact, const ice::CrackPlan& plan) {
  s.bearings.forget_within(plate.level_ice(), plan.centre, plan.reach);
  s.edges.forget(contact);
  s.edges.forget_within(plate.level_ice(), plan.centre, plan.reach);
  const double around = plan.reach + kEdgeReach * failure::characteristic_length(plate.ice());
  s.verdicts.forget_within(plate.level_ice(), plan.centre, plan.reach, around);
  s.sleep.wake_within(s.world, s.floes, plan.centre, plan.reach);
}

/// The ice cracks at a contact: level ice, floes and collision shapes follow. One random stream a break, so that a
/// resumed run draws the same.
Break break_off(State& s, const Laws& laws, const edge::EdgeContact& contact, Step& step) {
  const StageTimer::Scope clock(step.timer, step.report.times.cutting);
  const model::Case& c = laws.resolved;
  ice::Plate& plate = s.field.level_ice(contact.level_ice);
  statistics::RandomStream random(c.random.seed, c.random.replicate, "wedges", s.n_breaks++);
  const edge::EdgeContact placed = edge::before_the_notch(contact);
  const ice::CrackPlan plan = laws.pattern->plan(plate, placed.region, placed.assessment, random);
  forget_broken(s, plate, contact, plan);
  const Pose structure = s.sheets.seen_from(plate.level_ice(), s.motion->now()).pose;
  ice::Broken broken = s.field.break_off(plate, plan, edge::middle_outlines(edge_model(s, laws, plate), structure),
                                         c.failure.smallest_floe);
  for (const geometry::Extent& part : broken.severed) let_go(s, plate.level_ice(), part);
  Break made{.n_wedges = plan.n_wedges, .along_stress = plan.along_stress, .births = {}};
  step.broken.push_back({plate.level_ice(), plan.centre, plan.reach, broken.severed});
  const int level_ice = plate.level_ice();
  for (ice::Plate& piece : broken.pieces) let_float(s, laws, std::move(piece), level_ice, made.births, step);
  follow_outline(s, s.field.level_ice(level_ice), broken.changed);
  return made;
}

/// Parts of level ice that crushing has severed become bodies of their own. @return around them.
geometry::Extent release_severed(State& s, const Laws& laws, int level_ice, const Pose& structure, Step& step) {
  ice::Plate& plate = s.field.level_ice(level_ice);
  if (plate.sheet().n_parts() < 2) return {};
  ice::Broken severed = s.field.release_severed(plate, edge::middle_outlines(edge_model(s, laws, plate), structure),
                                                laws.resolved.failure.smallest_floe);
  for (const geometry::Extent& part : severed.severed) let_go(s, level_ice, part);
  for (ice::Plate& piece : severed.pieces) let_float(s, laws, std::move(piece), level_ice, step.report.births, step);
  return severed.changed;
}

Vec2 tip_of(const edge::EdgeContact& contact) { return 0.5 * (contact.region.chord_from + contact.region.chord_to); }

/// Whether the ice of a contact has broken in this step, or come loose.
bool has_broken(const Step& step, const edge::EdgeContact& contact) {
  const geometry::ContactRegion cut = edge::before_the_notch(contact).region;
  const Vec2 tip = tip_of(contact), middle = 0.5 * (cut.chord_from + cut.chord_to);
  return std::ranges::any_of(step.broken, [&](const BrokenIce& ice) {
    const auto is_loose = [&](const geometry::Extent& part) { return floes::is_on(part, tip); };
    return ice.level_ice == contact.level_ice &&
           (norm(ice.centre - middle) < ice.reach || norm(ice.centre - tip) < ice.reach ||
            std::ranges::any_of(ice.severed, is_loose));
  });
}

/// The data of a break before the ice is cut.
model::CrackEvent event_of(const State& s, const Laws& laws, const edge::EdgeContact& contact) {
  const edge::MovingEdges::Life life = s.edges.life(contact).value_or(edge::MovingEdges::Life{});
  return in_world(s, contact.level_ice,
                  {.time = s.time(laws),
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
                   .in_range = !contact.assessment.below_range && !contact.assessment.above_range,
                   .area_before = s.field.ledger().sheet.square_metres(),
                   .tip = tip_of(contact),
                   .towards = contact.region.normal,
                   .pressing_floe = contact.floe,
                   .edge_age = life.age,
                   .edge_deflection = life.deflection,
                   .thickness = contact.ice.thickness,
                   .flexural_strength = contact.ice.flexural_strength,
                   .overload = contact.assessment.overload});
}

}  // namespace

void initial_crack(State& s, const Laws& laws, Step& step) {
  edge::EdgeContact contact;
  const double radius =
      initial_crack_radius(laws.resolved, s.field.level_ice(contact.level_ice).ice(), *s.criteria.front());
  contact.assessment.breaking_length = radius;
  contact.region.normal = {1.0, 0.0};
  std::vector<double> ways;
  for (const Vec2 place : laws.hull->copies().places) {
    const Vec2 from = plan(to_world(s.motion->now().pose, {place.x, place.y, 0.0}));
    const std::optional<double> y = meets_edge(from, s.motion->course(), laws.resolved.field.width);
    if (!y || std::ranges::any_of(ways, [&](double way) { return std::abs(way - *y) < 2.0 * radius; })) continue;
    ways.push_back(*y);
    contact.region.chord_from = contact.region.chord_to = {0.0, *y};
    std::ranges::move(break_off(s, laws, contact, step).births, std::back_inserter(step.report.births));
  }
}

void let_float(State& s, const Laws& laws, ice::Plate&& piece, int level_ice, std::vector<model::FloeRecord>& births,
               Step& step) {
  const model::Case& c = laws.resolved;
  if (s.sheets.any() && edge::is_plate(piece.outline(), s.field.level_ice(level_ice).ice(), c.field.smallest_plate)) {
    const ice::Plate& made = s.field.level_ice(s.field.add_level_ice(std::move(piece)));
    s.sheets.add_part(made, level_ice);
    add_criterion(s, laws, made);
    s.edges.add_level_ice(level_ice);
    s.energy.book_left_sheets(-s.sheets.kinetic_energy(made.level_ice()));
    return;
  }
  const double mass_per_area = c.ice.density * piece.ice().thickness;
  std::optional<structure::State> ice;
  if (s.sheets.any()) ice = structure::State{s.sheets.start_pose(level_ice), s.sheets.twist(level_ice)};
  std::optional<model::FloeRecord> record = s.floes.add(s.world, std::move(piece), s.time(laws), ice);
  if (!record) {
    s.field.to_brash(piece);
    return;
  }
  const double mass = mass_per_area * record->area;
  if (floes::collision_time(c, mass) < c.time.step) ++step.report.n_steps_too_long;
  births.push_back(std::move(*record));
  if (!s.sheets.any()) return;
  const BodyId born = s.world.floes().back();
  s.watchdog.add_piece(s.floes.energy(s.world, born, s.floes.at(born)), born, born);
}

void follow_outline(State& s, const ice::Plate& plate, const geometry::Extent& changed) {
  const int number = plate.level_ice();
  s.tiles.renew(plate, s.world, changed, s.sheets.start_pose(number), s.sheets.id(number));
  if (!changed.is_empty()) s.energy.book_left_sheets(s.sheets.weigh(plate));
}

bool crush_passed_ice(State& s, const Laws& laws, double time, Step& step) {
  const StageTimer::Scope clock(step.timer, step.report.times.cutting);
  bool any = false;
  const int n_level_ice = static_cast<int>(s.field.level_ice().size());
  for (int number = 0; number < n_level_ice; ++number) {
    const ice::Plate& plate = s.field.level_ice(number);
    geometry::Extent changed;
    const double shift = s.edges.largest_shift(number, time);
    const structure::State structure = s.sheets.seen_from(number, s.motion->now());
    if (!is_near(s, laws, plate, structure)) continue;
    for (const geometry::Ring& outline : edge::trailing_outlines(edge_model(s, laws, plate), structure.pose, shift))
      changed.add(s.field.crush(s.field.level_ice(number), outline));
    if (!changed.is_empty()) changed.add(release_severed(s, laws, number, structure.pose, step));
    follow_outline(s, s.field.level_ice(number), changed);
    any = any || !changed.is_empty();
  }
  return any;
}

void break_ice(State& s, const Laws& laws, const std::vector<edge::EdgeContact>& contacts, Step& step) {
  for (const edge::EdgeContact& contact : contacts) {
    if (!contact.assessment.fails || has_broken(step, contact)) continue;
    look_for_interruption();
    model::CrackEvent event = event_of(s, laws, contact);
    Break made = break_off(s, laws, contact, step);
    event.wedges = made.n_wedges;
    const bool solves_sheet = edge_model(s, laws, s.field.level_ice(contact.level_ice)).criterion.needs_outline();
    step.report.breaks += {.under_floes = contact.floe == model::kNoFloe ? 0 : 1,
                           .radial_first = contact.assessment.split ? 1 : 0,
                           .true_edge = solves_sheet && !contact.assessment.outline_refused ? 1 : 0,
                           .along_stress = made.along_stress ? 1 : 0,
                           .buckled = contact.assessment.buckled ? 1 : 0};
    event.pieces = static_cast<int>(made.births.size());
    event.area_after = s.field.ledger().sheet.square_metres();
    step.report.events.push_back(event);
    std::ranges::move(made.births, std::back_inserter(step.report.births));
  }
}

}  // namespace brash::simulation
