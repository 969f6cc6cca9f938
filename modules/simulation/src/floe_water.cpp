// SPDX-License-Identifier: GPL-3.0-or-later
#include "floe_water.hpp"

#include <algorithm>

#include "brash/core/constants.hpp"
#include "brash/structure/hull.hpp"

namespace brash::simulation {
namespace {

using hydrodynamics::DragLaw;

/// Water::shading_gap of a case [m].
double shading_gap(const model::Case& resolved) {
  const model::HydrodynamicsSection& h = resolved.hydrodynamics;
  return h.shading && h.drag == DragLaw::kSurface ? h.shading_gap * resolved.ice.thickness : 0.0;
}

/// Applies weight and the load of `water` to a floe that has `drag` at its velocity.
void apply_to(rigid_body::World& world, BodyId body, Floe& floe, double dt, const hydrodynamics::Water& water,
              const hydrodynamics::Drag& drag) {
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

/// Below this share of the displacement at rest a floe loses its added mass, in proportion to what is wet.
constexpr double kWellWet = 0.5;

/// Gives a floe the added mass of its wet part. Added mass that leaves keeps its velocity; added mass that comes is at
/// rest and takes its share of the momentum, as in an impact on water.
void take_added_mass(rigid_body::World& world, BodyId body, Floe& floe, const model::Case& resolved) {
  const double at_rest = floe.weight / (kGravity * resolved.water.density);
  const double share = std::min(1.0, displaced(floe, world.pose(body)).volume / (kWellWet * at_rest));
  floe.shed = 0.0;
  if (share == floe.wet_share) return;
  const double before = world.kinetic_energy(body), old_mass = floe.inertia.mass;
  floe.wet_share = share;
  floe.inertia = inertia_of(floe, resolved);
  const Twist twist = world.twist(body);
  const double kept = std::min(1.0, old_mass / floe.inertia.mass);
  world.set_mass(body, floe.inertia, {kept * twist.linear, kept * twist.angular});
  floe.shed = before - world.kinetic_energy(body);
}

}  // namespace

FloeWater::FloeWater(const model::Case& resolved)
    : case_(&resolved),
      water_{.density = resolved.water.density,
             .current = {current_past_ice(resolved).x, current_past_ice(resolved).y, 0.0},
             .drag_law = resolved.hydrodynamics.drag,
             .form_drag = resolved.hydrodynamics.form_drag,
             .rotational_drag = resolved.hydrodynamics.rotational_drag,
             .skin_friction = resolved.hydrodynamics.skin_friction,
             .shading_gap = shading_gap(resolved),
             .form_drag_along = resolved.hydrodynamics.form_drag_along} {
  if (!resolved.hydrodynamics.structure_flow) return;
  const structure::Displacement hull = structure::make_hull(resolved.structure.shape)->displaced({});
  flow_.emplace(hull.waterplane.radius, hull.volume);
}

hydrodynamics::Water FloeWater::at(Vec3 position, const structure::State& structure) const {
  hydrodynamics::Water water = water_;
  const Vec3 origin{structure.pose.position.x, structure.pose.position.y, 0.0};
  if (flow_) water.current += flow_->at(position - origin, plan(structure.twist.linear - water_.current));
  return water;
}

void FloeWater::apply(rigid_body::World& world, FloePopulation& floes, double dt, const structure::State& structure) {
  due_.clear();
  for (const BodyId body : world.moving()) {
    Floe& floe = floes.at(body);
    take_added_mass(world, body, floe, *case_);
    const Pose pose = world.pose(body);
    const hydrodynamics::Water water = at(pose.position, structure);
    if (displaced(floe, pose).volume <= 0.0) {
      floe.kept_drag = {};
      apply_to(world, body, floe, dt, water, {});
    } else if (const auto drag = floe.kept_drag.follow(
                   floe.inertia, hydrodynamics::against_water(pose, world.twist(body), water), dt)) {
      apply_to(world, body, floe, dt, water, *drag);
    } else {
      due_.push_back(body);
    }
  }
  renew_drag(world, floes, dt, structure);
}

void FloeWater::renew_drag(rigid_body::World& world, FloePopulation& floes, double dt,
                           const structure::State& structure) {
  const double travel = case_->hydrodynamics.drag_travel * case_->ice.thickness;
  const auto renew = [&](BodyId body, std::span<const Solid> neighbours) {
    Floe& floe = floes.at(body);
    const Pose pose = world.pose(body);
    const Twist twist = world.twist(body);
    const hydrodynamics::Water water = at(pose.position, structure);
    floe.kept_drag = {hydrodynamics::drag(floe.prism, pose, twist, water, neighbours, displaced(floe, pose)),
                      hydrodynamics::against_water(pose, twist, water), travel};
    apply_to(world, body, floe, dt, water, floe.kept_drag.drag);
  };
  if (water_.shading_gap > 0.0)
    world.visit_neighbours(due_, reach(), renew);
  else
    for (const BodyId body : due_) renew(body, {});
}

}  // namespace brash::simulation
