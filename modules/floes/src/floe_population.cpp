// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/floes/floe_population.hpp"

#include <algorithm>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "brash/floes/plan.hpp"
#include "brash/structure/hull.hpp"

namespace brash::floes {
namespace {

/// By how much a floe is thicker than twice the collision margin, so that its shape outlasts round-off [m].
constexpr double kThinnest = 1e-6;

/// Weight and buoyancy (docs/theory/water.md, (H4)): m g z - rho_w g V z_B, zero for a massless point at z = 0
/// [J].
double potential(const Floe& floe, const Pose& pose, double water_density) {
  const hydrodynamics::Displacement& wet = displaced(floe, pose);
  return floe.weight * pose.position.z - water_density * kGravity * wet.volume * wet.centre.z;
}

/// The rotation by `second`, then by `first`.
constexpr Quaternion product(const Quaternion& first, const Quaternion& second) {
  const auto& [a, b, c, d] = first;
  const auto& [w, x, y, z] = second;
  return {a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y, a * y - b * z + c * w + d * x,
          a * z + b * y - c * x + d * w};
}

}  // namespace

const hydrodynamics::Displacement& displaced(const Floe& floe, const Pose& pose) {
  if (!floe.wet || floe.wet->first != pose) floe.wet.emplace(pose, hydrodynamics::displacement(floe.prism, pose));
  return floe.wet->second;
}

rigid_body::MassProperties inertia_of(const Floe& floe, const model::Case& resolved) {
  const model::HydrodynamicsSection& h = resolved.hydrodynamics;
  if (h.added_mass_law == model::AddedMassLaw::kIsotropic)
    return rigid_body::mass_properties(floe.prism, resolved.ice.density, floe.wet_share * h.added_mass);
  rigid_body::MassProperties mass = rigid_body::mass_properties(floe.prism, resolved.ice.density, 0.0);
  if (h.added_mass_law == model::AddedMassLaw::kNone) return mass;
  mass.mass += floe.wet_share * floe.added.along;
  mass.inertia += floe.wet_share * floe.added.inertia;
  mass.added_across = floe.wet_share * (floe.added.across - floe.added.along);
  return mass;
}

double collision_time(const model::Case& resolved, double mass) {
  return 0.5 * kPi * std::sqrt((1.0 + resolved.hydrodynamics.added_mass) * mass / resolved.contact.stiffness);
}

double averaging_share(const Floe& floe, double dt) { return 1.0 - std::exp(-dt / floe.collision_time); }

bool FloePopulation::complete(Floe& floe) const {
  const double h = floe.plate.ice().thickness;
  if (!(h > 2.0 * case_->contact.margin + kThinnest)) return false;
  const std::vector<geometry::Polygon> outline = floe.plate.outline();
  BRASH_EXPECTS(outline.size() == 1, outline.size());
  const geometry::Polygon& polygon = outline.front();
  const std::vector<geometry::Ring> parts = geometry::convex_parts(polygon);
  const bool has_shape = std::ranges::any_of(
      parts, [&](const geometry::Ring& part) { return !geometry::inset(part, case_->contact.margin).empty(); });
  if (!has_shape) return false;

  std::vector<std::vector<Vec2>> parts_in_metres;
  for (const geometry::Ring& part : parts) parts_in_metres.push_back(to_metres(part));
  const double mid_height = h * (0.5 - case_->ice.density / case_->water.density);
  rigid_body::PlacedPrism placed = rigid_body::place_prism(rings_in_metres(polygon), parts_in_metres, h, mid_height);

  floe.prism = std::move(placed.prism);
  floe.laid = placed.pose;
  floe.area = geometry::area(polygon);
  const double mass = case_->ice.density * h * floe.area.square_metres();
  floe.weight = mass * kGravity;
  floe.rest_potential = potential(floe, placed.pose, case_->water.density);
  if (case_->hydrodynamics.added_mass_law == model::AddedMassLaw::kPlate)
    floe.added = hydrodynamics::added_mass_of_plate(floe.prism, case_->water.density);
  floe.inertia = inertia_of(floe, *case_);
  floe.collision_time = collision_time(*case_, mass);
  return true;
}

std::optional<model::FloeRecord> FloePopulation::add(rigid_body::World& world, ice::Plate&& plate, double time,
                                                     const std::optional<structure::State>& ice) {
  // Afloat, one face of a plate is wet.
  const bool plate_law = case_->hydrodynamics.added_mass_law == model::AddedMassLaw::kPlate;
  Floe floe{.plate = std::move(plate), .wet_share = plate_law ? 0.5 : 1.0};
  if (!complete(floe)) {
    plate = std::move(floe.plate);
    return std::nullopt;
  }
  const Pose laid = floe.laid;
  if (!ice) return launch(world, std::move(floe), laid, {}, time);
  const Pose pose{to_world(ice->pose, laid.position), product(ice->pose.rotation, laid.rotation)};
  const Twist twist{velocity_at(ice->twist, pose.position - ice->pose.position), ice->twist.angular};
  return launch(world, std::move(floe), pose, twist, time);
}

std::optional<model::FloeRecord> FloePopulation::add_piece(rigid_body::World& world, ice::Plate&& plate,
                                                           const Floe& parent, const Pose& pose, const Twist& twist,
                                                           double time) {
  Floe floe{.plate = std::move(plate), .wet_share = parent.wet_share, .ran_in = parent.ran_in};
  if (!complete(floe)) {
    plate = std::move(floe.plate);
    return std::nullopt;
  }
  const Quaternion turned = product(conjugate(parent.laid.rotation), floe.laid.rotation);
  const Pose here{to_world(pose, to_body(parent.laid, floe.laid.position)), product(pose.rotation, turned)};
  const Vec3 velocity = velocity_at(twist, here.position - pose.position);
  model::FloeRecord record = launch(world, std::move(floe), here, {velocity, twist.angular}, time);
  record.parent = parent.id;
  return record;
}

model::FloeRecord FloePopulation::launch(rigid_body::World& world, Floe floe, const Pose& pose, const Twist& twist,
                                         double time) {
  floe.id = next_id_++;
  model::FloeRecord record{.id = floe.id,
                           .rings = floe.prism.rings,
                           .area = floe.area.square_metres(),
                           .birth = time,
                           .birth_pose = pose,
                           .thickness = floe.prism.thickness};
  const BodyId body = world.add_floe(floe.prism, floe.inertia, pose, twist);
  insert(body, std::move(floe));
  return record;
}

void FloePopulation::insert(BodyId body, Floe floe) {
  Floe& kept = floes_.emplace(body, std::move(floe)).first->second;
  if (by_body_.size() <= body.index) by_body_.resize(body.index + 1, nullptr);
  by_body_[body.index] = &kept;
  area_ += kept.area;
  weight_ += kept.weight;
  if (kept.rest.asleep) forget_asleep_height();
}

Floe FloePopulation::remove(rigid_body::World& world, BodyId body) {
  auto node = floes_.extract(body);
  BRASH_EXPECTS(!node.empty(), body.index, body.generation);
  by_body_[body.index] = nullptr;
  area_ -= node.mapped().area;
  weight_ = 0.0;  // recomputed: a difference would leave its rounding behind
  for (const auto& [other, floe] : floes_) weight_ += floe.weight;
  forget_asleep_height();
  world.remove(body);
  return std::move(node.mapped());
}

void FloePopulation::save(const rigid_body::World& world, model::Checkpoint& checkpoint) const {
  model::Table table{"floe", {}};
  for (const auto& [body, floe] : floes_) {
    const failure::IceProperties& ice = floe.plate.ice();
    const ice::PlatePart part{floe.plate.level_ice(), ice.thickness, ice.flexural_strength,
                              floe.plate.outline().front()};
    const Pose pose = world.pose(body);
    const Twist twist = world.twist(body);
    model::SavedRow row(table);
    ice::PlatePart::visit(part, row);
    Floe::visit(floe, row);
    model::visit_pose(pose, row);
    model::visit_twist(twist, row);
  }
  checkpoint.tables.push_back(std::move(table));
  model::save(checkpoint, "births", *this);
}

void FloePopulation::restore(rigid_body::World& world, std::span<const ice::Plate> level_ice,
                             const model::Checkpoint& checkpoint) {
  const model::Table& table = checkpoint.table("floe");
  for (std::size_t i = 0; i < table.n_rows(); ++i) {
    ice::PlatePart part;
    Pose pose;
    Twist twist;
    model::RestoredRow row(table, i);
    ice::PlatePart::visit(part, row);
    const auto number = static_cast<std::size_t>(part.level_ice);
    BRASH_EXPECTS(number < level_ice.size(), part.level_ice);
    failure::IceProperties ice = level_ice[number].ice();
    ice.thickness = part.thickness;
    ice.flexural_strength = part.flexural_strength;
    Floe floe{.plate = level_ice[number].piece(std::move(part.outline), ice)};
    Floe::visit(floe, row);
    model::visit_pose(pose, row);
    model::visit_twist(twist, row);
    BRASH_EXPECTS(complete(floe), floe.id);
    const BodyId body = world.add_floe(floe.prism, floe.inertia, pose, twist);
    if (floe.rest.asleep) {
      floe.asleep_height = raised(world, body, floe);
      world.set_settled(body, true);
    }
    insert(body, std::move(floe));
  }
  model::restore(checkpoint, "births", *this);
}

std::map<std::int64_t, BodyId> FloePopulation::bodies_by_id() const {
  std::map<std::int64_t, BodyId> bodies;
  for (const auto& [body, floe] : floes_) bodies[floe.id] = body;
  return bodies;
}

void FloePopulation::put_to_sleep(rigid_body::World& world, BodyId body) {
  Floe& floe = at(body);
  floe.rest = {.slow_for = 0.0, .asleep = true, .push = {}};
  floe.drag = floe.skin_friction = floe.pressure = {};
  floe.shed = 0.0;
  floe.asleep_height = raised(world, body, floe);
  world.set_settled(body, true);
  forget_asleep_height();
}

/// In the order of the bodies, so that the sum does not depend on which fell asleep first.
double FloePopulation::asleep_height() const {
  if (asleep_height_) return *asleep_height_;
  double sum = 0.0;
  for (const auto& [body, floe] : floes_)
    if (floe.rest.asleep) sum += floe.asleep_height;
  asleep_height_ = sum;
  return sum;
}

double FloePopulation::raised(const rigid_body::World& world, BodyId body, const Floe& floe) const {
  if (world.is_settled(body)) return floe.asleep_height;
  return potential(floe, world.pose(body), case_->water.density) - floe.rest_potential;
}

double FloePopulation::potential_energy(const rigid_body::World& world) const {
  const std::vector<BodyId>& moving = world.moving();
  return world.workers().sum(asleep_height(), moving.size(), kCheapFloes,
                             [&](std::size_t i) { return raised(world, moving[i], at(moving[i])); });
}

double FloePopulation::gained_by_parting(const rigid_body::World& world, BodyId body) const {
  const std::optional<Pose> unparted = world.unparted_pose(body);
  if (!unparted) return 0.0;
  const double before = potential(at(body), *unparted, case_->water.density);
  return potential(at(body), world.pose(body), case_->water.density) - before;
}

double FloePopulation::energy(const rigid_body::World& world, BodyId body, const Floe& floe) const {
  return world.kinetic_energy(body) + raised(world, body, floe);
}

}  // namespace brash::floes
