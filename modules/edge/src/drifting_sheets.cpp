// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/edge/drifting_sheets.hpp"

#include <algorithm>
#include <cmath>

#include "brash/core/contract.hpp"
#include "brash/floes/plan.hpp"

namespace brash::edge {
namespace {

/// Area and first and second moments of a polygon about `origin`, by Green's theorem.
struct Moments {
  double area = 0.0;
  Vec2 first{};
  double polar = 0.0;

  void add(const std::vector<Vec2>& ring, Vec2 origin) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i] - origin, b = ring[(i + 1) % ring.size()] - origin;
      const double twice = cross(a, b);
      area += 0.5 * twice;
      first += (twice / 6.0) * (a + b);
      polar += twice / 12.0 * (dot(a, a) + dot(a, b) + dot(b, b));
    }
  }
};

Vec2 turn(double angle, Vec2 v) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

/// Velocity of the sheet's centre.
Vec2 centre_velocity(const Drift& drift, const SheetBody& body) {
  return drift.velocity + drift.spin * perpendicular(turn(drift.angle, body.centre));
}

Vec2 centre_place(const Drift& drift, const SheetBody& body) { return drift.position + turn(drift.angle, body.centre); }

/// Where it was, to the bit, so that its tiles, which the step has moved, lie in it; its centre has another velocity.
Drift with_velocity(const Drift& drift, Vec2 of_centre, double spin, const SheetBody& body) {
  const Vec2 arm = turn(drift.angle, body.centre);
  return {drift.position, drift.angle, of_centre - spin * perpendicular(arm), spin};
}

/// Even motion, about the centre; docs/theory/fracture-of-floes.md, (G1), (G2).
Drift after(const Drift& drift, const SheetBody& body, double seconds) {
  const Vec2 velocity = centre_velocity(drift, body);
  const double angle = drift.angle + seconds * drift.spin;
  const Vec2 position = centre_place(drift, body) + seconds * velocity - turn(angle, body.centre);
  return with_velocity({position, angle}, velocity, drift.spin, body);
}

/// A sheet's row in a checkpoint.
struct SavedDrift {
  std::int64_t level_ice = 0;
  Drift drift;

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("level_ice", "1", "number of the level ice", self.level_ice);
    Drift::visit(self.drift, visit);
  }
};

}  // namespace

double SheetBody::breadth() const {
  const double largest = std::max(upper.x - lower.x, upper.y - lower.y);
  return largest > 0.0 ? area / largest : 0.0;
}

SheetBody sheet_body(const std::vector<geometry::Polygon>& outlines, double thickness, double density) {
  SheetBody body{.thickness = thickness};
  geometry::Extent extent;
  for (const geometry::Polygon& polygon : outlines) extent.add(geometry::extent(polygon));
  if (extent.is_empty()) return body;
  body.lower = extent.lower;
  body.upper = extent.upper;
  Moments moments;  // about the box's middle, so that a far origin costs no digits
  const Vec2 origin = 0.5 * (body.lower + body.upper);
  for (const geometry::Polygon& polygon : outlines)
    for (const std::vector<Vec2>& ring : floes::rings_in_metres(polygon)) moments.add(ring, origin);
  const Vec2 offset = moments.first / moments.area;
  body.area = moments.area;
  body.mass = density * thickness * moments.area;
  body.centre = origin + offset;
  body.inertia = density * thickness * (moments.polar - moments.area * dot(offset, offset));
  return body;
}

bool is_plate(const std::vector<geometry::Polygon>& outlines, const failure::IceProperties& ice, double smallest) {
  return sheet_body(outlines, ice.thickness, 1.0).breadth() >= smallest * failure::characteristic_length(ice);
}

Pose DriftingSheets::pose_of(const Drift& drift) {
  const double half = 0.5 * drift.angle;
  return {{drift.position.x, drift.position.y, 0.0}, {std::cos(half), 0.0, 0.0, std::sin(half)}};
}

void DriftingSheets::add(const ice::Plate& plate, const Drift& drift) {
  if (!any()) return;
  BRASH_EXPECTS(plate.level_ice() == static_cast<int>(sheets_.size()), plate.level_ice());
  sheets_.push_back({.id = world_->add_drifting_sheet(),
                     .now = drift,
                     .start = drift,
                     .body = sheet_body(plate.outline(), plate.ice().thickness, case_->ice.density),
                     .of_structure = {},
                     .form = {},
                     .skin = {},
                     .wind = {}});
}

double DriftingSheets::kinetic(const Sheet& sheet) {
  const Vec2 velocity = centre_velocity(sheet.now, sheet.body);
  return 0.5 * sheet.body.mass * dot(velocity, velocity) + 0.5 * sheet.body.inertia * sheet.now.spin * sheet.now.spin;
}

double DriftingSheets::weigh(const ice::Plate& plate) {
  if (!any()) return 0.0;
  Sheet& sheet = sheets_.at(static_cast<std::size_t>(plate.level_ice()));
  const double before = kinetic(sheet);
  const Vec2 old_centre = sheet.body.centre;
  sheet.body = sheet_body(plate.outline(), plate.ice().thickness, case_->ice.density);
  // The moment of this step's pushes about the new centre.
  const Vec2 moved = turn(sheet.now.angle, sheet.body.centre - old_centre);
  sheet.of_structure.moment -= cross(moved, sheet.of_structure.force);
  return before - kinetic(sheet);
}

Twist DriftingSheets::twist(int number) const {
  if (!any()) return {};
  const Drift& start = at(number).start;
  return {{start.velocity.x, start.velocity.y, 0.0}, {0.0, 0.0, start.spin}};
}

structure::State DriftingSheets::seen_from(int number, const structure::State& structure, double later) const {
  if (!any()) return structure;
  const Sheet& sheet = at(number);
  const Drift then = after(sheet.now, sheet.body, later);
  const Pose frame = pose_of(then);
  const Twist moves{{then.velocity.x, then.velocity.y, 0.0}, {0.0, 0.0, then.spin}};
  const Quaternion back = conjugate(frame.rotation);
  const auto& [pose, twist] = structure;
  const auto& [a, b, c, d] = back;
  const auto& [w, x, y, z] = pose.rotation;
  const Quaternion rotation{a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y, a * y - b * z + c * w + d * x,
                            a * z + b * y - c * x + d * w};
  const Vec3 relative = twist.linear - velocity_at(moves, pose.position - frame.position);
  return {{to_body(frame, pose.position), rotation},
          {rotate(back, relative), rotate(back, twist.angular - moves.angular)}};
}

void DriftingSheets::begin_step() {
  for (Sheet& sheet : sheets_) {
    sheet.start = sheet.now;
    sheet.of_structure = {};
  }
}

void DriftingSheets::advance(double seconds) {
  for (Sheet& sheet : sheets_) sheet.now = after(sheet.now, sheet.body, seconds);
}

void DriftingSheets::push(int number, Vec3 force, Vec3 point) {
  if (!any()) return;
  Sheet& sheet = sheets_.at(static_cast<std::size_t>(number));
  sheet.of_structure.force += plan(force);
  sheet.of_structure.moment += cross(plan(point) - centre_place(sheet.now, sheet.body), plan(force));
}

/// docs/theory/fracture-of-floes.md, (G3), (G4).
void DriftingSheets::load_by_water(Sheet& sheet, double dt) const {
  const model::Case& c = *case_;
  const SheetBody& body = sheet.body;
  const Vec2 past = centre_velocity(sheet.now, body) - current_past_ice(c);
  const double spin = sheet.now.spin;
  const double gyration = body.inertia / body.mass;  // squared [m2]
  const double draught = body.thickness * c.ice.density / c.water.density;
  const double speed = norm(past);
  // Width of the box across the motion, in the sheet's frame.
  const Vec2 across = speed > 0.0 ? perpendicular(turn(-sheet.now.angle, past)) / speed : Vec2{};
  const Vec2 size = body.upper - body.lower;
  const double width = std::abs(across.x) * size.x + std::abs(across.y) * size.y;
  const double half = 0.5 * c.water.density;
  const double form = half * c.hydrodynamics.form_drag * draught * width * speed;
  const double skin =
      half * c.hydrodynamics.skin_friction * body.area * std::sqrt(speed * speed + gyration * spin * spin);
  const double along = 1.0 + dt * (form + skin) / body.mass, around = 1.0 + dt * skin / body.mass;
  sheet.form = {(-form / along) * past, 0.0};
  sheet.skin = {(-skin / along) * past, -skin / around * gyration * spin};
}

/// docs/theory/ice.md, (F8), on a top that is dry.
void DriftingSheets::load_by_wind(Sheet& sheet) const {
  const model::WindSection& wind = case_->wind;
  const Vec2 past = wind.velocity - centre_velocity(sheet.now, sheet.body);
  sheet.wind = {};
  if (wind.velocity != Vec2{})
    sheet.wind.force = (wind.density * wind.skin_friction * sheet.body.area * norm(past)) * past;
}

void DriftingSheets::hand_over(double dt) {
  for (Sheet& sheet : sheets_) {
    const SheetBody& body = sheet.body;
    if (!(body.mass > 0.0)) {
      world_->set_sheet(sheet.id, {});
      continue;
    }
    load_by_water(sheet, dt);
    load_by_wind(sheet);
    Push all;
    for (const Push& push : {sheet.of_structure, sheet.form, sheet.skin, sheet.wind}) {
      all.force += push.force;
      all.moment += push.moment;
    }
    world_->set_sheet(sheet.id, {.mass = body.mass,
                                 .inertia = body.inertia,
                                 .centre = centre_place(sheet.start, body),
                                 .velocity = centre_velocity(sheet.now, body),
                                 .spin = sheet.now.spin,
                                 .force = all.force,
                                 .moment = all.moment});
  }
}

WorkOnSheets DriftingSheets::take_back(double dt) {
  WorkOnSheets work;
  for (Sheet& sheet : sheets_) {
    const SheetBody& body = sheet.body;
    if (!(body.mass > 0.0)) continue;
    const Twist after = world_->twist(sheet.id), mean = world_->mean_twist(sheet.id);
    const auto work_of = [&](const Push& push) {
      return dt * (dot(push.force, plan(mean.linear)) + push.moment * mean.angular.z);
    };
    work.edge += work_of(sheet.of_structure);
    work.form += work_of(sheet.form);
    work.skin += work_of(sheet.skin);
    work.wind += work_of(sheet.wind);
    sheet.now = with_velocity(sheet.now, plan(after.linear), after.angular.z, body);
  }
  return work;
}

double DriftingSheets::take_pushes(int number, double dt) {
  Sheet& sheet = sheets_.at(static_cast<std::size_t>(number));
  const double before = kinetic(sheet);
  const auto moved_on = [&](const Drift& drift) {
    return with_velocity(drift, centre_velocity(drift, sheet.body) + (dt / sheet.body.mass) * sheet.of_structure.force,
                         drift.spin + dt / sheet.body.inertia * sheet.of_structure.moment, sheet.body);
  };
  sheet.now = moved_on(sheet.now);
  sheet.start = moved_on(sheet.start);
  sheet.of_structure = {};
  return kinetic(sheet) - before;
}

void DriftingSheets::add_part(const ice::Plate& plate, int parent) {
  const Drift now = at(parent).now, start = at(parent).start;
  add(plate, now);
  sheets_.back().start = start;
}

double DriftingSheets::kinetic_energy() const {
  double sum = 0.0;
  for (const Sheet& sheet : sheets_) sum += kinetic(sheet);
  return sum;
}

std::vector<model::SheetMotion> DriftingSheets::motions() const {
  std::vector<model::SheetMotion> all;
  for (const Sheet& sheet : sheets_)
    all.push_back({sheet.body.mass, centre_place(sheet.now, sheet.body), sheet.now.angle,
                   centre_velocity(sheet.now, sheet.body), sheet.now.spin});
  return all;
}

void DriftingSheets::save(model::Checkpoint& checkpoint) const {
  if (!any()) return;
  model::Table table{"drift", {}};
  for (std::size_t i = 0; i < sheets_.size(); ++i) {
    const SavedDrift saved{static_cast<std::int64_t>(i), sheets_[i].now};
    model::SavedRow row(table);
    SavedDrift::visit(saved, row);
  }
  checkpoint.tables.push_back(std::move(table));
}

void DriftingSheets::restore(std::span<const ice::Plate> level_ice, const model::Checkpoint& checkpoint) {
  if (!any()) return;
  for (const Sheet& sheet : sheets_) world_->remove(sheet.id);
  sheets_.clear();
  const model::Table& table = checkpoint.table("drift");
  BRASH_EXPECTS(table.n_rows() == level_ice.size(), table.n_rows(), level_ice.size());
  for (std::size_t i = 0; i < table.n_rows(); ++i) {
    SavedDrift saved;
    model::RestoredRow row(table, i);
    SavedDrift::visit(saved, row);
    add(level_ice[i], saved.drift);
  }
}

}  // namespace brash::edge
