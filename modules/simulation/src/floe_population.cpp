// SPDX-License-Identifier: GPL-3.0-or-later
#include "floe_population.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "brash/simulation/cone_of.hpp"
#include "brash/simulation/scales.hpp"
#include "plan.hpp"

namespace brash::simulation {
namespace {

using hydrodynamics::DragLaw;

/// A floe is fixed after it has been slow for so long [s]: longer than it heaves once.
constexpr double kSettleTime = 2.0;
/// A mean push is forgotten when it is this share of what would let a cube of the ice go [-].
constexpr double kNoPush = 1e-3;

/// Water::shading_gap of a case [m].
double shading_gap(const model::Case& resolved) {
  const model::HydrodynamicsSection& h = resolved.hydrodynamics;
  return h.shading && h.drag == "surface" ? h.shading_gap * resolved.ice.thickness : 0.0;
}

const hydrodynamics::Displacement& displaced(const Floe& floe, const Pose& pose) {
  if (!floe.wet || floe.wet->first != pose) floe.wet.emplace(pose, hydrodynamics::displacement(floe.prism, pose));
  return floe.wet->second;
}

/// Weight and buoyancy (docs/theory/hydrodynamics.md, (H4)): m g z - rho_w g V z_B, zero for a massless point at z = 0
/// [J].
double potential(const Floe& floe, const Pose& pose, double water_density) {
  const hydrodynamics::Displacement& wet = displaced(floe, pose);
  return floe.weight * pose.position.z - water_density * kGravity * wet.volume * wet.centre.z;
}

/// Adds the symmetric part of arm x force to a stress (xx, yy, zz, xy, yz, zx).
void add_dipole(std::array<double, 6>& sum, Vec3 arm, Vec3 force) {
  sum[0] += arm.x * force.x;
  sum[1] += arm.y * force.y;
  sum[2] += arm.z * force.z;
  sum[3] += 0.5 * (arm.x * force.y + arm.y * force.x);
  sum[4] += 0.5 * (arm.y * force.z + arm.z * force.y);
  sum[5] += 0.5 * (arm.z * force.x + arm.x * force.z);
}

/// The largest principal compression, positive [same unit].
double largest_compression(const std::array<double, 6>& s) {
  Eigen::Matrix3d tensor;
  tensor << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(tensor, Eigen::EigenvaluesOnly);
  return -solver.eigenvalues()[0];
}

}  // namespace

FloePopulation::FloePopulation(const model::Case& resolved)
    : case_(&resolved),
      water_{.density = resolved.water.density,
             .current = {resolved.water.current.x, resolved.water.current.y, 0.0},
             .drag_law = resolved.hydrodynamics.drag == "paper" ? DragLaw::kPaper : DragLaw::kSurface,
             .form_drag = resolved.hydrodynamics.form_drag,
             .rotational_drag = resolved.hydrodynamics.rotational_drag,
             .skin_friction = resolved.hydrodynamics.skin_friction,
             .shading_gap = shading_gap(resolved)} {
  if (!resolved.hydrodynamics.structure_flow) return;
  const structure::Cone cone = cone_of(resolved);
  flow_.emplace(0.5 * cone.waterline_width, structure::displaced_volume(cone));
}

std::optional<Pose> FloePopulation::complete(Floe& floe) const {
  const std::vector<geometry::Ring> parts = geometry::convex_parts(floe.outline);
  const bool has_shape = std::ranges::any_of(
      parts, [&](const geometry::Ring& part) { return !geometry::inset(part, case_->contact.margin).empty(); });
  if (!has_shape) return std::nullopt;

  std::vector<std::vector<Vec2>> parts_in_metres;
  for (const geometry::Ring& part : parts) parts_in_metres.push_back(to_metres(part));
  const double h = case_->ice.thickness;
  const double mid_height = h * (0.5 - case_->ice.density / case_->water.density);
  rigid_body::PlacedPrism placed =
      rigid_body::place_prism(rings_in_metres(floe.outline), parts_in_metres, h, mid_height);

  floe.prism = std::move(placed.prism);
  floe.area = geometry::area(floe.outline);
  const double mass = case_->ice.density * h * floe.area.square_metres();
  floe.weight = mass * kGravity;
  floe.rest_potential = potential(floe, placed.pose, water_.density);
  floe.inertia = rigid_body::mass_properties(floe.prism, case_->ice.density, case_->hydrodynamics.added_mass);
  floe.collision_time = collision_time(*case_, mass);
  return placed.pose;
}

std::optional<model::FloeRecord> FloePopulation::add(rigid_body::World& world, const geometry::Polygon& polygon,
                                                     double time) {
  Floe floe;
  floe.outline = polygon;
  const std::optional<Pose> pose = complete(floe);
  if (!pose) return std::nullopt;
  floe.id = next_id_++;
  model::FloeRecord record{
      .id = floe.id, .rings = floe.prism.rings, .area = floe.area.square_metres(), .birth = time, .birth_pose = *pose};
  const BodyId body = world.add_floe(floe.prism, floe.inertia, *pose);
  insert(body, std::move(floe));
  return record;
}

void FloePopulation::insert(BodyId body, Floe floe) {
  Floe& kept = floes_.emplace(body, std::move(floe)).first->second;
  if (by_body_.size() <= body.index) by_body_.resize(body.index + 1, nullptr);
  by_body_[body.index] = &kept;
  area_ += kept.area;
  weight_ += kept.weight;
  if (kept.rest.settled) add_up_settled();
}

void FloePopulation::save(const rigid_body::World& world, model::Checkpoint& checkpoint) const {
  model::Table floes{"floe", {}};
  for (const auto& [body, floe] : floes_) {
    model::SavedRow row(floes);
    Floe::visit(floe, row);
    const Pose pose = world.pose(body);
    const Twist twist = world.twist(body);
    model::visit_pose(pose, row);
    model::visit_twist(twist, row);
  }
  model::Table pushes{"push", {}};
  for (const auto& [pair, force] : pushes_.pairs()) {
    const FloePush push{at(pair.first).id, at(pair.second).id, force};
    model::SavedRow row(pushes);
    FloePush::visit(push, row);
  }
  checkpoint.tables.push_back(std::move(floes));
  checkpoint.tables.push_back(std::move(pushes));
  model::save(checkpoint, "births", *this);
}

void FloePopulation::restore(rigid_body::World& world, const model::Checkpoint& checkpoint) {
  const model::Table& floes = checkpoint.table("floe");
  for (std::size_t i = 0; i < floes.n_rows(); ++i) {
    Floe floe;
    Pose pose;
    Twist twist;
    model::RestoredRow row(floes, i);
    Floe::visit(floe, row);
    model::visit_pose(pose, row);
    model::visit_twist(twist, row);
    BRASH_EXPECTS(complete(floe).has_value(), floe.id);
    const BodyId body = world.add_floe(floe.prism, floe.inertia, pose, twist);
    if (floe.rest.settled) {
      floe.settled_height = raised(world, body, floe);
      world.set_settled(body, true);
      pushed_.push_back(body);  // after the last look, perhaps
    }
    insert(body, std::move(floe));
  }
  restore_pushes(checkpoint.table("push"));
  model::restore(checkpoint, "births", *this);
}

void FloePopulation::restore_pushes(const model::Table& table) {
  std::map<std::int64_t, BodyId> bodies;
  for (const auto& [body, floe] : floes_) bodies[floe.id] = body;
  for (std::size_t i = 0; i < table.n_rows(); ++i) {
    FloePush push;
    model::RestoredRow row(table, i);
    FloePush::visit(push, row);
    pushes_.restore(bodies.at(push.floe), bodies.at(push.other), push.force);
  }
}

hydrodynamics::Water FloePopulation::water_at(Vec3 position, Vec2 structure) const {
  hydrodynamics::Water water = water_;
  if (flow_) water.current += flow_->at(position - Vec3{structure.x, structure.y, 0.0}, {case_->structure.speed, 0.0});
  return water;
}

void FloePopulation::apply_water_to(rigid_body::World& world, BodyId body, double dt, const hydrodynamics::Water& water,
                                    const hydrodynamics::Drag& drag) {
  Floe& floe = at(body);
  const Pose pose = world.pose(body);
  const hydrodynamics::StepInertia step{
      .dt = dt, .mass = floe.inertia.mass, .inertia = floe.inertia.inertia, .weight = floe.weight};
  const hydrodynamics::WaterLoad load =
      hydrodynamics::water_load(pose, world.twist(body), water, step, displaced(floe, pose), drag);
  Wrench wrench{{0.0, 0.0, -floe.weight}, {}};
  wrench += load.buoyancy;
  wrench += load.drag;
  wrench += load.skin_friction;
  world.apply(body, wrench);
  floe.drag = load.drag;
  floe.skin_friction = load.skin_friction;
}

/// The floes whose drag is to be taken anew come last, together, for their neighbours are sought together.
void FloePopulation::apply_water(rigid_body::World& world, double dt, Vec2 structure) {
  due_.clear();
  for (const BodyId body : world.moving()) {
    Floe& floe = at(body);
    const Pose pose = world.pose(body);
    const hydrodynamics::Water water = water_at(pose.position, structure);
    if (displaced(floe, pose).volume <= 0.0) {
      floe.kept_drag = {};
      apply_water_to(world, body, dt, water, {});
    } else if (const auto drag = floe.kept_drag.follow(
                   floe.inertia, hydrodynamics::against_water(pose, world.twist(body), water), dt)) {
      apply_water_to(world, body, dt, water, *drag);
    } else {
      due_.push_back(body);
    }
  }
  const double travel = case_->hydrodynamics.drag_travel * case_->ice.thickness;
  const auto renew = [&](BodyId body, std::span<const Solid> neighbours) {
    Floe& floe = at(body);
    const Pose pose = world.pose(body);
    const Twist twist = world.twist(body);
    const hydrodynamics::Water water = water_at(pose.position, structure);
    floe.kept_drag = {hydrodynamics::drag(floe.prism, pose, twist, water, neighbours, displaced(floe, pose)),
                      hydrodynamics::against_water(pose, twist, water), travel};
    apply_water_to(world, body, dt, water, floe.kept_drag.drag);
  };
  if (water_.shading_gap > 0.0)
    world.visit_neighbours(due_, reach(), renew);
  else
    for (const BodyId body : due_) renew(body, {});
}

void FloePopulation::average_contacts(const rigid_body::World& world, double dt) {
  for (const BodyId body : world.moving()) at(body).in_step = {};
  // In the order of their places, so that the sums do not depend on how the bodies came to their ids.
  std::vector<const rigid_body::ContactLoad*> contacts;
  for (const rigid_body::ContactLoad& contact : world.contacts()) contacts.push_back(&contact);
  std::ranges::sort(contacts, {}, [](const rigid_body::ContactLoad* c) {
    return std::tie(c->point.x, c->point.y, c->point.z, c->normal.x, c->normal.y, c->normal.z);
  });
  for (const rigid_body::ContactLoad* const contact : contacts) {
    const Vec3 force = contact->normal_force * contact->normal + contact->friction_force;
    ContactSums& sums = at(contact->body).in_step;
    add_dipole(sums.dipole, contact->point - world.pose(contact->body).position, force);
    if (contact->other_kind == rigid_body::BodyKind::kFloe)
      add_dipole(at(contact->other).in_step.dipole, contact->point - world.pose(contact->other).position, -force);
    if (contact->other_kind == rigid_body::BodyKind::kSheet) add_contact(sums.bearing, *contact);
  }
  for (const BodyId body : world.moving()) {
    Floe& floe = at(body);
    const double volume = floe.area.square_metres() * case_->ice.thickness;
    const double share = 1.0 - std::exp(-dt / floe.collision_time);
    const auto& [dipole, bearing] = floe.in_step;
    for (std::size_t i = 0; i < 6; ++i) floe.stress[i] += share * (dipole[i] / volume - floe.stress[i]);
    floe.peak_compression = std::max(floe.peak_compression, largest_compression(floe.stress));
    approach(floe.bearing, bearing, share);
  }
}

void FloePopulation::sheet_broke(rigid_body::World& world, Vec2 at, double radius) {
  for (auto& [body, floe] : floes_) {
    if (floe.bearing.weight > 0.0 && norm(floe.bearing.first / floe.bearing.weight - at) < radius) floe.bearing = {};
    if (!world.is_settled(body)) continue;
    const auto [lower, upper] = world.bounds(body);
    const Vec2 nearest{std::clamp(at.x, lower.x, upper.x), std::clamp(at.y, lower.y, upper.y)};
    if (norm(nearest - at) < radius) let_go(world, body, floe);
  }
}

double FloePopulation::slow_energy(const Floe& floe) const {
  return 0.5 * floe.inertia.mass * case_->time.settle_speed * case_->time.settle_speed;
}

double FloePopulation::slow_push(double mass) const { return mass * case_->time.settle_speed / kSettleTime; }

void FloePopulation::let_go(rigid_body::World& world, BodyId body, Floe& floe) {
  world.set_settled(body, false);
  woken(body, floe);
}

void FloePopulation::woken(BodyId body, Floe& floe) {
  floe.rest = {};
  floe.kept_drag = {};
  pushes_.wake(body);
  add_up_settled();
}

void FloePopulation::notice_let_go(const rigid_body::World& world) {
  for (const BodyId body : world.moving())
    if (Floe& floe = at(body); floe.rest.settled) woken(body, floe);
}

/// In the order of the bodies, so that the sum does not depend on what came to rest when.
void FloePopulation::add_up_settled() {
  settled_height_ = 0.0;
  for (const auto& [body, floe] : floes_)
    if (floe.rest.settled) settled_height_ += floe.settled_height;
}

void FloePopulation::push(BodyId body, Vec3 change) {
  at(body).rest.push += change;
  pushed_.push_back(body);
}

void FloePopulation::let_go_pushed(rigid_body::World& world) {
  for (const BodyId body : pushed_) {
    Floe* const floe = by_body_[body.index];
    if (floe == nullptr || !world.is_settled(body)) continue;
    if (norm(floe->rest.push) > slow_push(floe->inertia.mass)) let_go(world, body, *floe);
  }
  pushed_.clear();
}

double FloePopulation::settle(rigid_body::World& world, double astern) {
  if (case_->time.settle_speed == 0.0) return 0.0;
  const double dt = case_->time.step;
  const double cube = case_->ice.density * std::pow(case_->ice.thickness, 3);
  pushes_.average(world, 1.0 - std::exp(-dt / kSettleTime), kNoPush * slow_push(cube),
                  [&](BodyId body, Vec3 change) { push(body, change); });
  const std::vector<BodyId> moving = world.moving();
  let_go_pushed(world);
  double taken = 0.0;
  for (const BodyId body : moving) {
    Floe& floe = at(body);
    Rest& rest = floe.rest;
    const double kinetic = world.kinetic_energy(body);
    rest.slow_for = kinetic <= slow_energy(floe) ? rest.slow_for + dt : 0.0;
    if (rest.slow_for < kSettleTime || world.bounds(body).second.x >= astern) continue;
    rest = {.slow_for = 0.0, .settled = true, .push = {}};
    floe.bearing = {};
    floe.drag = floe.skin_friction = {};
    floe.settled_height = raised(world, body, floe);
    world.set_settled(body, true);
    add_up_settled();
    taken += kinetic;
  }
  return taken;
}

std::vector<BodyId> FloePopulation::overstressed(const rigid_body::World& world, double strength) const {
  std::vector<BodyId> bodies;
  for (const BodyId body : world.moving()) {
    const Floe& floe = at(body);
    if (floe.peak_compression > strength && largest_compression(floe.stress) > strength) bodies.push_back(body);
  }
  return bodies;
}

Floe FloePopulation::remove(rigid_body::World& world, BodyId body) {
  auto node = floes_.extract(body);
  BRASH_EXPECTS(!node.empty(), body.index, body.generation);
  by_body_[body.index] = nullptr;
  area_ -= node.mapped().area;
  weight_ = 0.0;  // added up anew, or rounding would stay behind
  for (const auto& [other, floe] : floes_) weight_ += floe.weight;
  add_up_settled();
  pushes_.forget(body, [&](BodyId other, Vec3 change) { push(other, change); });
  world.remove(body);
  return std::move(node.mapped());
}

double FloePopulation::raised(const rigid_body::World& world, BodyId body, const Floe& floe) const {
  if (world.is_settled(body)) return floe.settled_height;
  return potential(floe, world.pose(body), water_.density) - floe.rest_potential;
}

double FloePopulation::potential_energy(const rigid_body::World& world) const {
  double sum = settled_height_;
  for (const BodyId body : world.moving()) sum += raised(world, body, at(body));
  return sum;
}

double FloePopulation::energy(const rigid_body::World& world, BodyId body, const Floe& floe) const {
  return world.kinetic_energy(body) + raised(world, body, floe);
}

}  // namespace brash::simulation
