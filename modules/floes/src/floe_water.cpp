// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/floes/floe_water.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "brash/core/constants.hpp"
#include "brash/hydrodynamics/ventilation.hpp"
#include "brash/structure/hull.hpp"

namespace brash::floes {
namespace {

using hydrodynamics::DragLaw;

/// Floes that a thread takes at a time, at some 0.5 us for each, and 10 us where drag is computed.
constexpr std::size_t kFloes = 16;

/// Water::shading_gap of a case [m].
double shading_gap(const model::Case& resolved) {
  const model::HydrodynamicsSection& h = resolved.hydrodynamics;
  return h.shading && h.drag == DragLaw::kSurface ? h.shading_gap * resolved.ice.thickness : 0.0;
}

/// Load of accelerated water on a floe: on the water that it displaces, and on its added mass (H22).
/// @param displaced_mass  of water [kg], about `centre` in the body frame [m].
Wrench load_of(Vec3 acceleration, const Floe& floe, const Pose& pose, double displaced_mass, Vec3 centre) {
  const double ice = floe.weight / kGravity;
  const Vec3 on_displaced = displaced_mass * acceleration;
  const Vec3 on_added = rigid_body::momentum(floe.inertia, pose, acceleration) - ice * acceleration;
  return {on_displaced + on_added, cross(rotate(pose.rotation, centre), on_displaced)};
}

/// Below this share of the displacement at rest a floe loses its isotropic added mass, in proportion to its wet part.
constexpr double kWellWet = 0.5;

double share_now(const rigid_body::World& world, BodyId body, const Floe& floe, const model::Case& resolved) {
  const Pose pose = world.pose(body);
  if (resolved.hydrodynamics.added_mass_law == model::AddedMassLaw::kPlate)
    return hydrodynamics::wetted_share(floe.prism, pose, floe.flooded);
  const double at_rest = floe.weight / (kGravity * resolved.water.density);
  return std::min(1.0, displaced(floe, pose).volume / (kWellWet * at_rest));
}

/// The velocity after isotropic added mass has come or gone.
Twist by_share(const Twist& against_water, double old_mass, double mass) {
  const double kept = std::min(1.0, old_mass / mass);
  return {kept * against_water.linear, kept * against_water.angular};
}

/// The same for a plate: momentum is kept along each axis.
Twist by_axis(const Twist& against_water, const Pose& pose, const rigid_body::MassProperties& old,
              const rigid_body::MassProperties& now) {
  const Vec3 w = rotate(conjugate(pose.rotation), against_water.angular), i = old.inertia, j = now.inertia;
  return {rigid_body::velocity_of(now, pose, rigid_body::momentum(old, pose, against_water.linear)),
          rotate(pose.rotation, {i.x / j.x * w.x, i.y / j.y * w.y, i.z / j.z * w.z})};
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
             .form_drag_along = resolved.hydrodynamics.form_drag_along},
      wind_{.velocity = {resolved.wind.velocity.x, resolved.wind.velocity.y, 0.0},
            .density = resolved.wind.density,
            .skin_friction = resolved.wind.skin_friction} {
  if (!resolved.hydrodynamics.structure_flow) return;
  const auto hull = structure::make_hull(resolved.structure);
  const structure::HullCopies copies = hull->copies();
  const auto body = structure::fitted_ellipsoid(*copies.hull);
  flow_.emplace(body.semi_axes);
  const double half = 0.5 * body.heading;
  for (const Vec2 place : copies.places)
    ellipsoids_.push_back(
        {{body.centre.x + place.x, body.centre.y + place.y, 0.0}, {std::cos(half), 0.0, 0.0, std::sin(half)}});
}

FloeWater::Flow FloeWater::flow_at(Vec3 position, const structure::State& structure) const {
  // Heave, trim and heel of the structure move no water along the surface.
  const Quaternion& q = structure.pose.rotation;
  const double heading = std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
  const Pose hull{{structure.pose.position.x, structure.pose.position.y, 0.0},
                  {std::cos(0.5 * heading), 0.0, 0.0, std::sin(0.5 * heading)}};
  const Quaternion& turned = ellipsoids_.front().rotation;
  const auto inwards = [&](Vec3 v) { return rotate(conjugate(turned), rotate(conjugate(hull.rotation), v)); };
  const auto outwards = [&](Vec3 v) { return rotate(hull.rotation, rotate(turned, v)); };
  const auto distance = [&](const Pose& ellipsoid) {
    return norm(plan(position - to_world(hull, ellipsoid.position)));
  };
  const Vec3 centre = to_world(hull, std::ranges::min_element(ellipsoids_, {}, distance)->position);
  const Twist moves{structure.twist.linear, {0.0, 0.0, structure.twist.angular.z}};
  const Vec2 velocity = plan(inwards(velocity_at(moves, centre - hull.position) - water_.current));
  const Vec3 point = inwards(position - centre);
  return {outwards(flow_->at(point, velocity)), outwards(flow_->acceleration(point, velocity))};
}

void FloeWater::meet(rigid_body::World& world, BodyId body, Floe& floe, double dt,
                     const structure::State& structure) const {
  const model::HydrodynamicsSection& laws = case_->hydrodynamics;
  const Pose pose = world.pose(body);
  const Flow flow = flow_ ? flow_at(pose.position, structure) : Flow{};
  floe.stream = water_.current + flow.velocity;
  floe.pressure = {};
  if (laws.ventilation) {
    const hydrodynamics::SunkTop top = hydrodynamics::sunk_top(floe.prism, pose, water_.density);
    floe.ran_in = hydrodynamics::ran_in_after(floe.ran_in, top, dt);
    floe.flooded = hydrodynamics::flooded_share(floe.ran_in, top);
    const double dry = 1.0 - floe.flooded;
    floe.pressure = {-dry * top.pressure.force, -dry * top.pressure.moment};
  }
  if (wind_.velocity != Vec3{}) floe.pressure += hydrodynamics::wind_load(floe.prism, pose, world.twist(body), wind_);
  take_added_mass(world, body, floe, *case_, floe.stream);
  world.set_stream(body, floe.stream);
  if (!flow_) return;
  const hydrodynamics::Displacement wet = displaced(floe, pose);
  floe.pressure += load_of(flow.acceleration, floe, pose, water_.density * wet.volume, wet.centre_in_body);
}

hydrodynamics::Water FloeWater::around(const Floe& floe) const {
  hydrodynamics::Water water = water_;
  water.current = floe.stream;
  return water;
}

void FloeWater::apply_to(rigid_body::World& world, BodyId body, Floe& floe, double dt,
                         const hydrodynamics::Drag& drag) const {
  const Pose pose = world.pose(body);
  const hydrodynamics::StepInertia step{.dt = dt,
                                        .mass = floe.inertia.mass,
                                        .inertia = floe.inertia.inertia,
                                        .weight = floe.weight,
                                        .added_across = floe.inertia.added_across};
  const hydrodynamics::WaterLoad load = hydrodynamics::water_load(pose, world.twist(body), around(floe), step,
                                                                  displaced(floe, pose), drag, floe.pressure);
  Wrench wrench{{0.0, 0.0, -floe.weight}, {}};
  wrench += load.buoyancy;
  wrench += load.drag;
  wrench += load.skin_friction;
  wrench += floe.pressure;
  world.apply(body, wrench);
  floe.drag = load.drag;
  floe.skin_friction = load.skin_friction;
}

bool FloeWater::load(rigid_body::World& world, BodyId body, Floe& floe, double dt,
                     const structure::State& structure) const {
  meet(world, body, floe, dt, structure);
  const Pose pose = world.pose(body);
  if (displaced(floe, pose).volume <= 0.0) {
    floe.kept_drag = {};
    apply_to(world, body, floe, dt, {});
    return false;
  }
  const auto drag =
      floe.kept_drag.follow(floe.inertia, hydrodynamics::against_water(pose, world.twist(body), around(floe)), dt);
  if (drag) apply_to(world, body, floe, dt, *drag);
  return !drag;
}

void FloeWater::apply(rigid_body::World& world, FloePopulation& floes, double dt,
                      const structure::State& structure) const {
  const std::vector<BodyId>& moving = world.moving();
  std::vector<std::uint8_t> is_due(moving.size(), 0);
  world.workers().each(moving.size(), kFloes, [&](std::size_t i) {
    is_due[i] = load(world, moving[i], floes.at(moving[i]), dt, structure) ? 1 : 0;
  });
  std::vector<BodyId> due;
  for (std::size_t i = 0; i < moving.size(); ++i)
    if (is_due[i] != 0) due.push_back(moving[i]);
  renew_drag(world, floes, due, dt);
}

void FloeWater::renew_drag(rigid_body::World& world, FloePopulation& floes, const std::vector<BodyId>& due,
                           double dt) const {
  const double travel = case_->hydrodynamics.drag_travel * case_->ice.thickness;
  const auto renew = [&](BodyId body, std::span<const Solid> neighbours) {
    Floe& floe = floes.at(body);
    const Pose pose = world.pose(body);
    const Twist twist = world.twist(body);
    const hydrodynamics::Water water = around(floe);
    floe.kept_drag = {hydrodynamics::drag(floe.prism, pose, twist, water, neighbours, displaced(floe, pose)),
                      hydrodynamics::against_water(pose, twist, water), travel};
    apply_to(world, body, floe, dt, floe.kept_drag.drag);
  };
  if (water_.shading_gap > 0.0)
    world.visit_neighbours(due, reach(), renew);
  else
    world.workers().each(due.size(), kFloes, [&](std::size_t i) { renew(due[i], {}); });
}

void take_added_mass(rigid_body::World& world, BodyId body, Floe& floe, const model::Case& resolved, Vec3 stream) {
  floe.shed = 0.0;
  if (resolved.hydrodynamics.added_mass_law == model::AddedMassLaw::kNone) return;
  const double share = share_now(world, body, floe, resolved);
  if (share == floe.wet_share) return;
  const double before = world.kinetic_energy(body);
  const rigid_body::MassProperties old = floe.inertia;
  const bool comes = share > floe.wet_share;
  floe.wet_share = share;
  floe.inertia = inertia_of(floe, resolved);
  const Twist twist = world.twist(body);
  Twist against{twist.linear - stream, twist.angular};
  if (resolved.hydrodynamics.added_mass_law == model::AddedMassLaw::kIsotropic)
    against = by_share(against, old.mass, floe.inertia.mass);
  else if (comes)
    against = by_axis(against, world.pose(body), old, floe.inertia);
  world.set_mass(body, floe.inertia, {against.linear + stream, against.angular});
  floe.shed = before - world.kinetic_energy(body);
}

}  // namespace brash::floes
