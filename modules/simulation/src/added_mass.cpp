// SPDX-License-Identifier: GPL-3.0-or-later
#include "added_mass.hpp"

#include <algorithm>

#include "brash/core/constants.hpp"

namespace brash::simulation {
namespace {

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

}  // namespace brash::simulation
