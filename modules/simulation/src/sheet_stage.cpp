// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets with free borders: they move, take their loads, split in their plane, and become floes when they are small.
#include <algorithm>
#include <utility>

#include "brash/failure/splitting.hpp"
#include "plan.hpp"
#include "simulation_impl.hpp"
#include "splitting_force.hpp"

namespace brash::simulation {

namespace {

/// Parts of sheets are laid where another box comes this near [m]: far more than a sheet moves in a step, and than it
/// is crushed by another.
constexpr double kNear = 1.0;

Pose inverse(const Pose& pose) {
  const Quaternion back = conjugate(pose.rotation);
  return {rotate(back, -pose.position), back};
}

/// The box around a box that a pose turns and moves.
geometry::Extent moved_box(const geometry::Extent& box, const Pose& pose) {
  geometry::Extent moved;
  for (const Vec2 corner : {box.lower, Vec2{box.upper.x, box.lower.y}, box.upper, Vec2{box.lower.x, box.upper.y}})
    moved.add(plan(to_world(pose, {corner.x, corner.y, 0.0})));
  return moved;
}

bool are_apart(const geometry::Extent& a, const geometry::Extent& b, double distance) {
  return a.lower.x > b.upper.x + distance || b.lower.x > a.upper.x + distance || a.lower.y > b.upper.y + distance ||
         b.lower.y > a.upper.y + distance;
}

/// A ring turned and moved with its sheet.
geometry::Ring moved(const geometry::Ring& ring, const Pose& frame) {
  std::vector<Vec2> points = to_metres(ring);
  for (Vec2& p : points) p = plan(to_world(frame, {p.x, p.y, 0.0}));
  return geometry::ring(points);
}

}  // namespace

/// Where the level ice is. A sheet that drifts is rounded to the grid anew.
std::vector<geometry::Polygon> Simulation::Impl::outlines_in_world() const {
  if (!sheets.any()) return field.outlines();
  std::vector<geometry::Polygon> all;
  for (const ice::Plate& plate : field.level_ice()) {
    const Pose frame = sheets.pose(plate.level_ice());
    for (geometry::Polygon polygon : plate.outline()) {
      polygon.outline = moved(polygon.outline, frame);
      for (geometry::Ring& hole : polygon.holes) hole = moved(hole, frame);
      all.push_back(std::move(polygon));
    }
  }
  return all;
}

/// An event of level ice that drifts, where it was.
model::CrackEvent Simulation::Impl::in_world(int level_ice, model::CrackEvent event) const {
  const auto place = [&](Vec2 p) { return plan(sheets.to_world(level_ice, {p.x, p.y, 0.0})); };
  event.at = place(event.at);
  event.tip = place(event.tip);
  event.towards = plan(sheets.turned(level_ice, {event.towards.x, event.towards.y, 0.0}));
  return event;
}

/// The collision shapes of level ice wherever the floe could meet them, or be in the lee of them, in this step.
void Simulation::Impl::lay_sheet_near(BodyId body) {
  const auto has_ice = [](const ice::Plate& plate) { return !plate.is_gone(); };
  if (std::ranges::none_of(field.level_ice(), has_ice)) return;  // a field of floes
  const Vec2 reach{water.reach(), water.reach()};
  const auto [lower, upper] = world.bounds(body);
  const geometry::Extent near{plan(lower) - reach, plan(upper) + reach};
  for (const ice::Plate& plate : field.level_ice()) {
    if (!sheets.any()) {
      tiles.lay(plate, world, near.lower, near.upper);
      continue;
    }
    const int number = plate.level_ice();
    const Pose frame = sheets.start_pose(number);
    const geometry::Extent here = moved_box(near, inverse(frame));
    const SheetBody& ice = sheets.body(number);
    if (!(ice.mass > 0.0) || are_apart(here, {ice.lower, ice.upper}, 0.0)) continue;
    tiles.lay(plate, world, here.lower, here.upper, frame, sheets.id(number));
  }
}

/// The collision shapes of each sheet wherever it could meet another sheet, a wall or a shore in this step.
void Simulation::Impl::lay_sheets_that_meet() {
  std::vector<geometry::Extent> boxes;  // of the sheets, in the world
  for (const ice::Plate& plate : field.level_ice()) {
    const SheetBody& body = sheets.body(plate.level_ice());
    boxes.push_back(body.mass > 0.0 ? moved_box({body.lower, body.upper}, sheets.start_pose(plate.level_ice()))
                                    : geometry::Extent{});
  }
  for (const ice::Plate& plate : field.level_ice()) {
    const auto own = static_cast<std::size_t>(plate.level_ice());
    const auto lay = [&](const geometry::Extent& other) {
      if (boxes[own].is_empty() || other.is_empty() || are_apart(boxes[own], other, kNear)) return;
      const Pose frame = sheets.start_pose(plate.level_ice());
      tiles.lay_edge(plate, world, moved_box(other, inverse(frame)), kNear, frame, sheets.id(plate.level_ice()));
    };
    for (std::size_t i = 0; i < boxes.size(); ++i)
      if (i != own) lay(boxes[i]);
    for (const geometry::Extent& border : borders) lay(border);
  }
}

/// Sheets and their collision shapes go into the step of the bodies.
void Simulation::Impl::hand_over_sheets() {
  if (!sheets.any()) return;
  lay_sheets_that_meet();
  for (const ice::Plate& plate : field.level_ice()) {
    const int number = plate.level_ice();
    tiles.move(number, world, sheets.pose(number), sheets.twist(number));
  }
  sheets.hand_over(resolved.time.step);
}

/// The step of the bodies has found the velocities of the sheets.
void Simulation::Impl::take_back_sheets() {
  if (!sheets.any()) return;
  energy.book_sheets(world, sheets.take_back(resolved.time.step), resolved.time.step);
}

/// Whether the hull comes near the box of level ice. Fast ice is large, and always counts as near.
bool Simulation::Impl::is_near(const ice::Plate& plate, const structure::State& seen) const {
  if (!sheets.any()) return true;
  const SheetBody& body = sheets.body(plate.level_ice());
  const Vec2 at = plan(seen.pose.position), reach{hull_reach, hull_reach};
  return body.mass > 0.0 && !are_apart({at - reach, at + reach}, {body.lower, body.upper}, 0.0);
}

/// Sheets split whose toughness the structure's splitting force exceeds; docs/theory/free-sheet.md, (G6), (G7), (G8).
void Simulation::Impl::split_sheets(const std::vector<EdgeContact>& contacts, StepReport& report) {
  if (!sheets.any()) return;
  const StageTimer::Scope clock(timer, times.cutting);
  const int n_sheets = static_cast<int>(field.level_ice().size());
  for (int number = 0; number < n_sheets; ++number) {
    const std::optional<SplittingForce> force = splitting_force(contacts, number);
    if (!force) continue;
    const ice::Plate& plate = field.level_ice(number);
    const std::optional<failure::SplitPlate> ahead = rectangle_ahead(plate.sheet(), *force);
    if (!ahead) continue;
    const failure::SplittingLoad load{force->opening, force->push, plate.ice().thickness};
    const double intensity = failure::least_intensity(load, *ahead);
    if (intensity < resolved.ice.fracture_toughness) continue;
    const double area_before = field.ledger().sheet.square_metres();
    ice::Broken broken =
        field.split_sheet(field.level_ice(number), force->at, force->towards, resolved.failure.smallest_floe);
    if (broken.changed.is_empty()) continue;
    const double reach = norm(broken.changed.upper - broken.changed.lower);
    bearings.forget_within(number, force->at, reach);
    edges.forget_within(number, force->at, reach);
    report.breaks.sheets_split += 1;
    const Vec2 at = plan(sheets.to_world(number, {force->at.x, force->at.y, 0.0}));
    const Vec2 towards = plan(sheets.turned(number, {force->towards.x, force->towards.y, 0.0}));
    report.splits.push_back({.time = time(),
                             .at = at,
                             .towards = towards,
                             .length = ahead->length,
                             .breadth = ahead->breadth,
                             .opening = load.opening,
                             .push = load.push,
                             .stress_intensity = intensity,
                             .thickness = load.thickness,
                             .area_before = area_before,
                             .pieces = static_cast<int>(broken.pieces.size()) + 1});
    for (ice::Plate& piece : broken.pieces) let_float(std::move(piece), number, report.births, report);
    follow_outline(field.level_ice(number), broken.changed);
    report.splits.back().area_after = field.ledger().sheet.square_metres();
  }
}

/// A sheet that has become small goes on as a floe.
void Simulation::Impl::release_small_sheets(StepReport& report) {
  if (!sheets.any()) return;
  const int n_sheets = static_cast<int>(field.level_ice().size());
  for (int number = 0; number < n_sheets; ++number) {
    ice::Plate& plate = field.level_ice(number);
    const std::vector<geometry::Polygon> outlines = plate.outline();
    if (outlines.empty() || is_plate(outlines, plate.ice(), resolved.field.smallest_plate)) continue;
    geometry::Extent changed;
    for (const geometry::Polygon& polygon : outlines) changed.add(geometry::extent(polygon));
    const double reach = norm(changed.upper - changed.lower);
    bearings.forget_within(number, 0.5 * (changed.lower + changed.upper), reach);
    edges.forget_within(number, 0.5 * (changed.lower + changed.upper), reach);
    energy.book_pushed_sheet(sheets.take_pushes(number, resolved.time.step));
    std::vector<ice::Plate> pieces = field.release(plate, resolved.failure.smallest_floe);
    for (ice::Plate& piece : pieces) let_float(std::move(piece), number, report.births, report);
    follow_outline(field.level_ice(number), changed);
  }
}

}  // namespace brash::simulation
