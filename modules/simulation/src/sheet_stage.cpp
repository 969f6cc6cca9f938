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

/// The collision shapes go with their sheets in the step of the bodies.
void Simulation::Impl::move_sheets() {
  if (!sheets.any()) return;
  for (const ice::Plate& plate : field.level_ice()) {
    const int number = plate.level_ice();
    tiles.move(number, world, sheets.pose(number), sheets.twist(number));
  }
}

/// Floes have pushed the sheets, and so has the structure before.
void Simulation::Impl::drift_sheets() {
  if (!sheets.any()) return;
  for (const rigid_body::ContactLoad& contact : world.contacts()) {
    if (contact.other_kind != rigid_body::BodyKind::kSheet) continue;
    const std::optional<int> level_ice = tiles.level_ice_of(contact.other);
    if (!level_ice) continue;  // a wall or a shore
    const Vec3 force = contact.normal_force * contact.normal + contact.friction_force;
    sheets.push(*level_ice, -force, contact.point, false);
  }
  energy.book_sheets(world, sheets.accelerate(resolved.time.step), resolved.time.step);
}

/// Whether ice afloat is broad enough to bend as a plate.
bool Simulation::Impl::is_plate(const std::vector<geometry::Polygon>& outlines) const {
  const double l_c = failure::characteristic_length(field.level_ice().front().ice());
  const SheetBody body = sheet_body(outlines, resolved.ice.thickness, resolved.ice.density);
  return body.breadth() >= resolved.field.smallest_plate * l_c;
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
    if (broken.pieces.empty()) continue;
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
    if (outlines.empty() || is_plate(outlines)) continue;
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
