// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets with free borders: they move, take their loads, split in their plane, and become floes when they are small.
#include <algorithm>
#include <utility>

#include "brash/edge/splitting_force.hpp"
#include "brash/failure/splitting.hpp"
#include "brash/floes/plan.hpp"
#include "stages.hpp"

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
  std::vector<Vec2> points = floes::to_metres(ring);
  for (Vec2& p : points) p = plan(to_world(frame, {p.x, p.y, 0.0}));
  return geometry::ring(points);
}

/// The collision shapes of each sheet wherever it could meet another sheet, a wall or a shore in this step.
void lay_sheets_that_meet(State& s) {
  std::vector<geometry::Extent> boxes;  // of the sheets, in the world
  for (const ice::Plate& plate : s.field.level_ice()) {
    const edge::SheetBody& body = s.sheets.body(plate.level_ice());
    boxes.push_back(body.mass > 0.0 ? moved_box({body.lower, body.upper}, s.sheets.start_pose(plate.level_ice()))
                                    : geometry::Extent{});
  }
  for (const ice::Plate& plate : s.field.level_ice()) {
    const auto own = static_cast<std::size_t>(plate.level_ice());
    const auto lay = [&](const geometry::Extent& other) {
      if (boxes[own].is_empty() || other.is_empty() || are_apart(boxes[own], other, kNear)) return;
      const Pose frame = s.sheets.start_pose(plate.level_ice());
      s.tiles.lay_edge(plate, s.world, moved_box(other, inverse(frame)), kNear, frame, s.sheets.id(plate.level_ice()));
    };
    for (std::size_t i = 0; i < boxes.size(); ++i)
      if (i != own) lay(boxes[i]);
    for (const geometry::Extent& border : s.borders) lay(border);
  }
}

/// A sheet splits or becomes a floe: pressures on it within `reach` of `at` are forgotten.
void forget_ice(State& s, int number, Vec2 at, double reach) {
  s.bearings.forget_within(number, at, reach);
  s.edges.forget_within(number, at, reach);
  s.verdicts.forget_within(number, at, reach, reach);
}

}  // namespace

std::vector<geometry::Polygon> outlines_in_world(const State& s) {
  if (!s.sheets.any()) return s.field.outlines();
  std::vector<geometry::Polygon> all;
  for (const ice::Plate& plate : s.field.level_ice()) {
    const Pose frame = s.sheets.pose(plate.level_ice());
    for (geometry::Polygon polygon : plate.outline()) {
      polygon.outline = moved(polygon.outline, frame);
      for (geometry::Ring& hole : polygon.holes) hole = moved(hole, frame);
      all.push_back(std::move(polygon));
    }
  }
  return all;
}

model::CrackEvent in_world(const State& s, int level_ice, model::CrackEvent event) {
  const auto place = [&](Vec2 p) { return plan(s.sheets.to_world(level_ice, {p.x, p.y, 0.0})); };
  event.at = place(event.at);
  event.tip = place(event.tip);
  event.towards = plan(s.sheets.turned(level_ice, {event.towards.x, event.towards.y, 0.0}));
  return event;
}

void lay_sheet_near(State& s, const Laws& laws, BodyId body) {
  const auto has_ice = [](const ice::Plate& plate) { return !plate.is_gone(); };
  if (std::ranges::none_of(s.field.level_ice(), has_ice)) return;  // a field of floes
  const Vec2 reach{laws.water.reach(), laws.water.reach()};
  const auto [lower, upper] = s.world.bounds(body);
  const geometry::Extent near{plan(lower) - reach, plan(upper) + reach};
  for (const ice::Plate& plate : s.field.level_ice()) {
    if (!s.sheets.any()) {
      s.tiles.lay(plate, s.world, near.lower, near.upper);
      continue;
    }
    const int number = plate.level_ice();
    const Pose frame = s.sheets.start_pose(number);
    const geometry::Extent here = moved_box(near, inverse(frame));
    const edge::SheetBody& ice = s.sheets.body(number);
    if (!(ice.mass > 0.0) || are_apart(here, {ice.lower, ice.upper}, 0.0)) continue;
    s.tiles.lay(plate, s.world, here.lower, here.upper, frame, s.sheets.id(number));
  }
}

void hand_over_sheets(State& s, const Laws& laws) {
  if (!s.sheets.any()) return;
  lay_sheets_that_meet(s);
  for (const ice::Plate& plate : s.field.level_ice()) {
    const int number = plate.level_ice();
    s.tiles.move(number, s.world, s.sheets.pose(number), s.sheets.twist(number));
  }
  s.sheets.hand_over(laws.resolved.time.step);
}

void take_back_sheets(State& s, const Laws& laws) {
  if (!s.sheets.any()) return;
  s.energy.book_sheets(s.world, s.sheets.take_back(laws.resolved.time.step), laws.resolved.time.step);
}

bool is_near(const State& s, const Laws& laws, const ice::Plate& plate, const structure::State& seen) {
  if (!s.sheets.any()) return true;
  const edge::SheetBody& body = s.sheets.body(plate.level_ice());
  const Vec2 at = plan(seen.pose.position), reach{laws.hull_reach, laws.hull_reach};
  return body.mass > 0.0 && !are_apart({at - reach, at + reach}, {body.lower, body.upper}, 0.0);
}

void split_sheets(State& s, const Laws& laws, const std::vector<edge::EdgeContact>& contacts, Step& step) {
  if (!s.sheets.any()) return;
  const StageTimer::Scope clock(step.timer, step.report.times.cutting);
  const int n_sheets = static_cast<int>(s.field.level_ice().size());
  for (int number = 0; number < n_sheets; ++number) {
    const std::optional<edge::SplittingForce> force = edge::splitting_force(contacts, number);
    if (!force) continue;
    const ice::Plate& plate = s.field.level_ice(number);
    const std::optional<failure::SplitPlate> ahead = edge::rectangle_ahead(plate.sheet(), *force);
    if (!ahead) continue;
    const failure::SplittingLoad load{force->opening, force->push, plate.ice().thickness};
    const double intensity = failure::least_intensity(load, *ahead);
    if (intensity < laws.resolved.ice.fracture_toughness) continue;
    const double area_before = s.field.ledger().sheet.square_metres();
    ice::Broken broken =
        s.field.split_sheet(s.field.level_ice(number), force->at, force->towards, laws.resolved.failure.smallest_floe);
    if (broken.changed.is_empty()) continue;
    const double reach = norm(broken.changed.upper - broken.changed.lower);
    forget_ice(s, number, force->at, reach);
    step.report.breaks.sheets_split += 1;
    const Vec2 at = plan(s.sheets.to_world(number, {force->at.x, force->at.y, 0.0}));
    const Vec2 towards = plan(s.sheets.turned(number, {force->towards.x, force->towards.y, 0.0}));
    step.report.splits.push_back({.time = s.time(laws),
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
    for (ice::Plate& piece : broken.pieces) let_float(s, laws, std::move(piece), number, step.report.births, step);
    follow_outline(s, s.field.level_ice(number), broken.changed);
    step.report.splits.back().area_after = s.field.ledger().sheet.square_metres();
  }
}

void release_small_sheets(State& s, const Laws& laws, Step& step) {
  if (!s.sheets.any()) return;
  const int n_sheets = static_cast<int>(s.field.level_ice().size());
  for (int number = 0; number < n_sheets; ++number) {
    ice::Plate& plate = s.field.level_ice(number);
    const std::vector<geometry::Polygon> outlines = plate.outline();
    if (outlines.empty() || edge::is_plate(outlines, plate.ice(), laws.resolved.field.smallest_plate)) continue;
    geometry::Extent changed;
    for (const geometry::Polygon& polygon : outlines) changed.add(geometry::extent(polygon));
    const double reach = norm(changed.upper - changed.lower);
    forget_ice(s, number, 0.5 * (changed.lower + changed.upper), reach);
    s.energy.book_pushed_sheet(s.sheets.take_pushes(number, laws.resolved.time.step));
    std::vector<ice::Plate> pieces = s.field.release(plate, laws.resolved.failure.smallest_floe);
    for (ice::Plate& piece : pieces) let_float(s, laws, std::move(piece), number, step.report.births, step);
    follow_outline(s, s.field.level_ice(number), changed);
  }
}

}  // namespace brash::simulation
