// SPDX-License-Identifier: GPL-3.0-or-later
// The first stage of a step: the structure moves through level ice, which is crushed, judged and broken.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>

#include "brash/core/error.hpp"
#include "brash/simulation/scales.hpp"
#include "initial_crack.hpp"
#include "local_ice.hpp"
#include "plan.hpp"
#include "simulation_impl.hpp"

namespace brash::simulation {
namespace {

/// How far along the ice edge, x = 0, the way of a point of the structure meets it [m]; none if it misses the sheet.
std::optional<double> meets_edge(Vec2 from, Vec2 course, double width) {
  if (from.x > 0.0 || course.x <= 0.0) return {};
  const double y = from.y - from.x * (course.y / course.x);
  if (std::abs(y) >= 0.5 * width) return {};
  return y;
}

void count_range(const failure::Assessment& assessment, StepReport& report) {
  report.n_above_range += assessment.above_range ? 1 : 0;
  report.n_below_range += assessment.below_range ? 1 : 0;
  report.sheets += assessment.solves;
}

/// A part of a step ends where the ice is expected to have just failed, if the whole part would go too far; overload of
/// the most overloaded contact.
constexpr double kTooFar = 1.05, kJustFailed = 1.02;
/// The overload grows almost evenly within a step.
constexpr int kTries = 2;
/// The free edge matters this far from a contact, in characteristic lengths.
constexpr double kEdgeReach = 3.0;

}  // namespace

EdgeModel Simulation::Impl::edge_model(const ice::Plate& plate) const {
  const ice::Variation& variation = field.variation();
  return {*hull, resolved, plate.ice(), *criteria[static_cast<std::size_t>(plate.level_ice())],
          variation ? &variation : nullptr};
}

/// Fig. 5: the ice has broken once before the structure comes; ahead of each leg that has a way of its own, along the
/// course at the start.
void Simulation::Impl::initial_crack() {
  EdgeContact contact;
  const double radius = initial_crack_radius(resolved, field.level_ice(contact.level_ice).ice(), *criteria.front());
  contact.assessment.breaking_length = radius;
  contact.region.normal = {1.0, 0.0};
  std::vector<double> ways;
  StepReport report;
  for (const Vec2 place : hull->copies().places) {
    const Vec2 from = plan(to_world(motion->now().pose, {place.x, place.y, 0.0}));
    const std::optional<double> y = meets_edge(from, motion->course(), resolved.field.width);
    if (!y || std::ranges::any_of(ways, [&](double way) { return std::abs(way - *y) < 2.0 * radius; })) continue;
    ways.push_back(*y);
    contact.region.chord_from = contact.region.chord_to = {0.0, *y};
    std::ranges::move(break_off(contact, report).births, std::back_inserter(initial_births));
  }
}

/// Level ice in a box has come loose: what presses there presses no more, and floes around it wake.
void Simulation::Impl::let_go(int level_ice, const geometry::Extent& box) {
  bearings.forget_within(level_ice, box);
  edges.forget_within(level_ice, box);
  verdicts.forget_within(level_ice, box);
  const Vec2 to_corner = 0.5 * (box.upper - box.lower);
  sleep.wake_within(world, floes, box.lower + to_corner, norm(to_corner));
}

/// The ice cracks at a contact: level ice, floes and collision shapes follow. One random stream a break, so that a
/// resumed run draws the same.
Break Simulation::Impl::break_off(const EdgeContact& contact, StepReport& report) {
  const StageTimer::Scope clock(timer, times.cutting);
  ice::Plate& plate = field.level_ice(contact.level_ice);
  statistics::RandomStream random(resolved.random.seed, resolved.random.replicate, "wedges", n_breaks++);
  const EdgeContact placed = before_the_notch(contact);
  const ice::CrackPlan plan = pattern->plan(plate, placed.region, placed.assessment, random);
  bearings.forget_within(plate.level_ice(), plan.centre, plan.reach);
  edges.forget(contact);
  edges.forget_within(plate.level_ice(), plan.centre, plan.reach);
  const double around = plan.reach + kEdgeReach * failure::characteristic_length(plate.ice());
  verdicts.forget_within(plate.level_ice(), plan.centre, plan.reach, around);
  sleep.wake_within(world, floes, plan.centre, plan.reach);
  const Pose structure = sheets.seen_from(plate.level_ice(), motion->now()).pose;
  ice::Broken broken =
      field.break_off(plate, plan, middle_outlines(edge_model(plate), structure), resolved.failure.smallest_floe);
  for (const geometry::Extent& part : broken.severed) let_go(plate.level_ice(), part);
  Break made{.n_wedges = plan.n_wedges, .along_stress = plan.along_stress, .births = {}};
  broken_in_step.push_back({plate.level_ice(), plan.centre, plan.reach, broken.severed});
  const int level_ice = plate.level_ice();
  for (ice::Plate& piece : broken.pieces) let_float(std::move(piece), level_ice, made.births, report);
  follow_outline(field.level_ice(level_ice), broken.changed);
  return made;
}

/// A piece of level ice goes on as a body of its own: a floe, or a large piece of a drifting sheet as another sheet.
void Simulation::Impl::let_float(ice::Plate&& piece, int level_ice, std::vector<model::FloeRecord>& births,
                                 StepReport& report) {
  if (sheets.any() && is_plate(piece.outline(), field.level_ice(level_ice).ice(), resolved.field.smallest_plate)) {
    const ice::Plate& made = field.level_ice(field.add_level_ice(std::move(piece)));
    sheets.add_part(made, level_ice);
    add_judge(made);
    edges.add_level_ice(level_ice);
    energy.book_left_sheets(-sheets.kinetic_energy(made.level_ice()));
    return;
  }
  const double mass_per_area = resolved.ice.density * piece.ice().thickness;
  std::optional<structure::State> ice;
  if (sheets.any()) ice = structure::State{sheets.start_pose(level_ice), sheets.twist(level_ice)};
  std::optional<model::FloeRecord> record = floes.add(world, std::move(piece), time(), ice);
  if (!record) {
    field.to_brash(piece);
    return;
  }
  const double mass = mass_per_area * record->area;
  if (collision_time(resolved, mass) < resolved.time.step) ++report.n_steps_too_long;
  births.push_back(std::move(*record));
  if (!sheets.any()) return;
  const BodyId born = world.floes().back();
  watchdog.add_piece(floes.energy(world, born, floes.at(born)), born, born);
}

/// The outline of level ice has changed: collision shapes and mass follow.
void Simulation::Impl::follow_outline(const ice::Plate& plate, const geometry::Extent& changed) {
  tiles.renew(plate, world, changed, sheets.start_pose(plate.level_ice()), sheets.id(plate.level_ice()));
  if (!changed.is_empty()) energy.book_left_sheets(sheets.weigh(plate));
}

/// Every contact of the structure with level ice, were the structure in `state` at `time`; not yet judged.
/// @param later  how long the sheets drift on until then [s].
std::vector<EdgeContact> Simulation::Impl::contacts_at(const structure::State& state, double later, double time) const {
  std::vector<EdgeContact> contacts;
  for (const ice::Plate& plate : field.level_ice()) {
    const auto shift = [&](const Touch& touched) { return edges.shift(plate.level_ice(), touched, time); };
    const structure::State seen = sheets.seen_from(plate.level_ice(), state, later);
    if (!is_near(plate, seen)) continue;
    for (EdgeContact& contact : edge_contacts(edge_model(plate), plate.sheet(), seen, shift)) {
      contact.level_ice = plate.level_ice();
      contacts.push_back(std::move(contact));
    }
  }
  return contacts;
}

/// Moves the structure by the largest part of `share` of the step that keeps within two limits; `share` becomes that
/// part. Contacts stay below the failure model's upper range (Sec. 2.2.2: "a shorter time step can avoid it"). It
/// cannot where a contact is above already: the step is then left whole. And no ice is loaded far beyond its strength,
/// as far as the verdicts before can tell: docs/theory/simulation.md, (S7). The trailing outlines then crush the ice
/// that they cover. So the contacts belong to the state that is reached, however short or long the step.
///
/// @param done  parts of the step before.
std::vector<EdgeContact> Simulation::Impl::move_within_limits(double& share, double done, StepReport& report) {
  const double shortest = 1.0 / resolved.failure.max_substeps;
  const auto time_after = [&](double part) { return time() + (done + part) * resolved.time.step; };
  const auto contacts_after = [&](double part) {
    return contacts_at(motion->after(part), part * resolved.time.step, time_after(part));
  };
  const auto above_range = [&](const std::vector<EdgeContact>& contacts) {
    return std::ranges::any_of(contacts, [&](const EdgeContact& contact) {
      const EdgeModel sheet = edge_model(field.level_ice()[static_cast<std::size_t>(contact.level_ice)]);
      return contact.load.pressure > 0.0 && LocalIce(sheet, contact).model().criterion.above_range(contact.load);
    });
  };
  std::vector<EdgeContact> contacts = contacts_after(share);
  if (0.5 * share >= shortest && above_range(contacts) && !above_range(contacts_after(0.0))) {
    do {
      share *= 0.5;
      contacts = contacts_after(share);
    } while (0.5 * share >= shortest && above_range(contacts));
  }

  for (int i = 0; i < kTries && share > shortest; ++i) {
    weigh_loads(contacts);
    const auto growth = verdicts.most_overloaded(contacts);
    if (!growth || growth->now <= kTooFar) break;
    const double part = (kJustFailed - growth->before) / (growth->now - growth->before);
    share = std::max(shortest, part * share);
    contacts = contacts_after(share);
  }

  motion->advance(share);
  sheets.advance(share * resolved.time.step);
  if (crush_passed_ice(time_after(share), report)) contacts = contacts_at(motion->now(), 0.0, time_after(share));
  return contacts;
}

void Simulation::Impl::weigh_loads(std::vector<EdgeContact>& contacts) const {
  for_each_sheet(contacts, [&](const ice::Plate& plate, std::vector<EdgeContact>& here) {
    simulation::weigh_loads(edge_model(plate), here);
  });
}

/// Adds the edges of level ice under the floes that press on them, by their forces up to the step before. In the order
/// of the floes; not yet judged.
void Simulation::Impl::add_contacts_of_floes(std::vector<EdgeContact>& contacts) const {
  if (!resolved.failure.under_floes) return;
  for (const auto& [pair, bearing] : bearings.all()) {
    const auto& [body, level_ice] = pair;
    const ice::Plate& plate = field.level_ice()[static_cast<std::size_t>(level_ice)];
    auto contact = bearing_contact(edge_model(plate), plate.sheet(), floes.at(body).id, bearing);
    if (!contact) continue;
    contact->level_ice = level_ice;
    contacts.push_back(std::move(*contact));
  }
}

/// Judges the contacts of each level ice together. @return the most stressed one first where loads act together: it
/// breaks the ice first.
void Simulation::Impl::judge(std::vector<EdgeContact>& contacts, double now, StepReport& report) {
  const auto motion_of = [this](const EdgeContact& contact) { return edges.motion(contact); };
  const auto share_out = [this](std::size_t n, const auto& judge) {
    const StageTimer::Scope clock(timer, times.failure);
    workers.each(n, 1, judge);
  };
  for_each_sheet(contacts, [&](const ice::Plate& plate, std::vector<EdgeContact>& here) {
    simulation::weigh_loads(edge_model(plate), here);
    for (EdgeContact& contact : here)
      if (const auto life = edges.life(contact)) contact.edge_age = life->age;
    verdicts.recall(now, here);
    assess(edge_model(plate), plate.sheet(), here, motion_of, share_out);
  });
  for (const EdgeContact& contact : contacts) count_range(contact.assessment, report);
  report.verdicts += verdicts.keep(now, contacts);
  if (resolved.failure.joint_loads)
    std::ranges::stable_sort(contacts, std::greater{}, [](const EdgeContact& c) { return c.assessment.sigma_max; });
}

/// The structure has penetrated the whole thickness of the ice that the trailing outlines cover. This ice is crushed
/// and leaves its plate, and the parts that it has held go on by themselves. @return whether there was any.
bool Simulation::Impl::crush_passed_ice(double time, StepReport& report) {
  const StageTimer::Scope clock(timer, times.cutting);
  bool any = false;
  const int n_level_ice = static_cast<int>(field.level_ice().size());
  for (int number = 0; number < n_level_ice; ++number) {
    const ice::Plate& plate = field.level_ice(number);
    geometry::Extent changed;
    const double shift = edges.largest_shift(number, time);
    const structure::State structure = sheets.seen_from(number, motion->now());
    if (!is_near(plate, structure)) continue;
    for (const geometry::Ring& outline : trailing_outlines(edge_model(plate), structure.pose, shift))
      changed.add(field.crush(field.level_ice(number), outline));
    if (!changed.is_empty()) changed.add(release_severed(number, structure.pose, report));
    follow_outline(field.level_ice(number), changed);
    any = any || !changed.is_empty();
  }
  return any;
}

/// Parts of level ice that crushing has severed go on as bodies of their own. @return around them.
geometry::Extent Simulation::Impl::release_severed(int level_ice, const Pose& structure, StepReport& report) {
  ice::Plate& plate = field.level_ice(level_ice);
  if (plate.sheet().n_parts() < 2) return {};
  ice::Broken severed =
      field.release_severed(plate, middle_outlines(edge_model(plate), structure), resolved.failure.smallest_floe);
  for (const geometry::Extent& part : severed.severed) let_go(level_ice, part);
  for (ice::Plate& piece : severed.pieces) let_float(std::move(piece), level_ice, report.births, report);
  return severed.changed;
}

/// Whether the ice of a contact has broken in this step, or come loose.
bool Simulation::Impl::has_broken(const EdgeContact& contact) const {
  const geometry::ContactRegion cut = before_the_notch(contact).region;
  const Vec2 tip = 0.5 * (contact.region.chord_from + contact.region.chord_to);
  const Vec2 middle = 0.5 * (cut.chord_from + cut.chord_to);
  return std::ranges::any_of(broken_in_step, [&](const BrokenIce& ice) {
    const auto is_loose = [&](const geometry::Extent& part) { return is_on(part, tip); };
    return ice.level_ice == contact.level_ice &&
           (norm(ice.centre - middle) < ice.reach || norm(ice.centre - tip) < ice.reach ||
            std::ranges::any_of(ice.severed, is_loose));
  });
}

/// Breaks the ice at every contact whose stress exceeds the flexural strength, in the contacts' order; a contact as
/// near to a break of this step as its crack reaches is left to the next step.
void Simulation::Impl::break_ice(const std::vector<EdgeContact>& contacts, StepReport& report) {
  for (const EdgeContact& contact : contacts) {
    const Vec2 tip = 0.5 * (contact.region.chord_from + contact.region.chord_to);
    if (!contact.assessment.fails || has_broken(contact)) continue;
    const MovingEdges::Life life = edges.life(contact).value_or(MovingEdges::Life{});
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
                            .in_range = !contact.assessment.below_range && !contact.assessment.above_range,
                            .area_before = field.ledger().sheet.square_metres(),
                            .tip = tip,
                            .towards = contact.region.normal,
                            .pressing_floe = contact.floe,
                            .edge_age = life.age,
                            .edge_deflection = life.deflection,
                            .thickness = contact.ice.thickness,
                            .flexural_strength = contact.ice.flexural_strength,
                            .overload = contact.assessment.overload};
    event = in_world(contact.level_ice, event);
    Break made = break_off(contact, report);
    event.wedges = made.n_wedges;
    const bool solves_sheet = edge_model(field.level_ice(contact.level_ice)).criterion.needs_outline();
    report.breaks += {.under_floes = contact.floe == model::kNoFloe ? 0 : 1,
                      .radial_first = contact.assessment.split ? 1 : 0,
                      .true_edge = solves_sheet && !contact.assessment.outline_refused ? 1 : 0,
                      .along_stress = made.along_stress ? 1 : 0,
                      .buckled = contact.assessment.buckled ? 1 : 0};
    event.pieces = static_cast<int>(made.births.size());
    event.area_after = field.ledger().sheet.square_metres();
    report.events.push_back(event);
    std::ranges::move(made.births, std::back_inserter(report.births));
  }
}

/// The plane of the ice has an end, and so has the motion of a body that another program or its loads throw about.
void Simulation::Impl::expect_on_the_plane() const {
  const Vec3 then = motion->after(1.0).pose.position;
  const double farthest = geometry::kMaxCoordinate - hull_reach;
  if (std::abs(then.x) <= farthest && std::abs(then.y) <= farthest && std::abs(then.z) <= farthest) return;
  throw RunError(fmt::format("the structure goes to ({:.6g}, {:.6g}, {:.6g}) m, beyond the plane of the ice", then.x,
                             then.y, then.z));
}

/// Work of the structure on the ice of each contact in a time [s], while its sheet drifts [J].
std::vector<double> Simulation::Impl::work_on(const std::vector<EdgeContact>& contacts, double seconds) const {
  std::vector<double> work;
  for (const EdgeContact& contact : contacts) {
    const structure::State seen = sheets.seen_from(contact.level_ice, motion->now());
    work.push_back(seconds * dot(contact.on_ice, velocity_at(seen.twist, contact.point - seen.pose.position)));
  }
  return work;
}

/// Moves the structure through one step: contacts, crushing, wedges, failures and cracks, in as many parts as
/// move_within_limits() asks for. @return the crushing load on it, mean over the parts, sheet axes.
Wrench Simulation::Impl::advance_through_ice(StepReport& report) {
  const StageTimer::Scope clock(timer, times.contacts);
  expect_on_the_plane();
  sheets.begin_step();
  broken_in_step.clear();
  Wrench crushing;
  region_loads.begin_step();
  double done = 0.0;
  for (report.n_substeps = 1; done < 1.0; ++report.n_substeps) {
    double share = 1.0 - done;
    std::vector<EdgeContact> contacts = move_within_limits(share, done, report);
    const double from = time() + done * resolved.time.step;
    done += share;
    const std::vector<double> work = work_on(contacts, share * resolved.time.step);
    energy.book_bent_edges(edges.follow(contacts, work, from, time() + done * resolved.time.step));
    for (const EdgeContact& contact : contacts) {
      const Vec3 point = sheets.to_world(contact.level_ice, contact.point);
      const Vec3 force = -sheets.turned(contact.level_ice, contact.on_ice);
      const Vec3 arm = point - motion->now().pose.position;
      crushing += {share * force, share * cross(arm, force)};
      sheets.push(contact.level_ice, -share * force, point);
      const Vec3 normal = sheets.turned(contact.level_ice, contact.normal);
      region_loads.add_crushing(motion->now().pose, point, normal, share * force);
    }
    const std::vector<EdgeContact> of_structure = sheets.any() ? contacts : std::vector<EdgeContact>{};
    add_contacts_of_floes(contacts);
    judge(contacts, time() + done * resolved.time.step, report);
    break_ice(contacts, report);
    split_sheets(of_structure, report);
  }
  release_small_sheets(report);
  --report.n_substeps;
  for (model::CrackEvent& event : report.events) event.substeps = report.n_substeps;
  world.move_structure(structure_body, motion->now().pose, motion->now().twist);
  return crushing;
}

BreakCounts& BreakCounts::operator+=(const BreakCounts& other) {
  under_floes += other.under_floes;
  radial_first += other.radial_first;
  true_edge += other.true_edge;
  along_stress += other.along_stress;
  buckled += other.buckled;
  sheets_split += other.sheets_split;
  return *this;
}

}  // namespace brash::simulation
