// SPDX-License-Identifier: GPL-3.0-or-later
#include "energy_ledger.hpp"

namespace brash::simulation {
namespace {

using rigid_body::BodyKind;
using rigid_body::ContactLoad;
using rigid_body::World;

/// The bed takes all that the ice gives it, heat or work: like a current, it has no work of its own in the balance.
void book_bed(model::EnergyLosses& losses, const ContactLoad& contact, double dt) {
  losses.bed_contact -= dt * contact.normal_force * dot(contact.normal, contact.body_velocity);
  losses.bed_friction -= dt * dot(contact.friction_force, contact.body_velocity);
}

void book(model::EnergyLosses& losses, const ContactLoad& contact, double dt) {
  const double normal = -dt * rigid_body::normal_power(contact);
  const double friction = -dt * rigid_body::friction_power(contact);
  const auto add = [&](double& of_contact, double& of_friction) {
    of_contact += normal;
    of_friction += friction;
  };
  if (contact.other_kind == BodyKind::kStructure) add(losses.structure_contact, losses.structure_friction);
  if (contact.other_kind == BodyKind::kSheet) add(losses.sheet_contact, losses.sheet_friction);
  if (contact.other_kind == BodyKind::kFloe) add(losses.floe_contact, losses.floe_friction);
  if (contact.other_kind == BodyKind::kBed) book_bed(losses, contact, dt);
}

WorkOfWater work_of_water(const World& world, BodyId body, const floes::Floe& floe, double dt) {
  const Twist twist = world.mean_twist(body);
  return {
      .drag = dt * power(floe.drag, twist),
      .skin_friction = dt * power(floe.skin_friction, twist),
      .pressure = dt * power(floe.pressure, twist) + world.gained_by_turning(body),
      .taken = dt * (power(floe.drag, world.loaded_twist(body)) + power(floe.skin_friction, world.start_twist(body)))};
}

}  // namespace

void EnergyLedger::book_structure(const Wrench& edge, const Wrench& floes, const Twist& passage) {
  Wrench load = edge;
  load += floes;
  work_ += power(load, passage);
  losses_.edge += power(edge, passage);
}

void EnergyLedger::book_bent_edges(double work) {
  losses_.bending += work;
  losses_.edge -= work;
}

/// Contacts first: they reach two floes each, so one thread books them.
void EnergyLedger::book_step(const World& world, const floes::FloePopulation& floes, std::int64_t first_newborn,
                             double dt) {
  taken_ = {};
  const std::vector<BodyId>& moving = world.moving();
  if (!floes.floes().empty()) received_.resize(floes.floes().rbegin()->first.index + 1);
  for (const BodyId body : moving) received_[body.index] = 0.0;
  for (const ContactLoad& contact : world.contacts()) {
    book(losses_, contact, dt);
    taken_.contacts += contact.loss;
    const Vec3 force = contact.normal_force * contact.normal + contact.friction_force;
    received_[contact.body.index] += dt * dot(force, contact.body_velocity);
    if (contact.other_kind == BodyKind::kFloe)
      received_[contact.other.index] -= dt * dot(force, contact.other_velocity);
  }
  from_water_.resize(moving.size());
  world.workers().each(moving.size(), floes::kCheapFloes, [&](std::size_t i) {
    from_water_[i] = work_of_water(world, moving[i], floes.at(moving[i]), dt);
  });
  for (std::size_t i = 0; i < moving.size(); ++i) {
    const BodyId body = moving[i];
    const floes::Floe& floe = floes.at(body);
    const auto& [drag, skin_friction, pressure, taken] = from_water_[i];
    taken_.water += floe.shed;
    taken_.water -= taken;
    losses_.drag += floe.shed - drag - pressure;
    losses_.skin_friction -= skin_friction;
    // Parting moves a floe without a velocity.
    const double parted = floes.gained_by_parting(world, body);
    losses_.floe_contact -= parted;
    received_[body.index] += drag + skin_friction - floe.shed + pressure + parted;
    if (floe.id >= first_newborn) birth_ += floes.energy(world, body, floe) - received_[body.index];
  }
}

/// docs/theory/fracture-of-floes.md, (G5). What contacts with floes gave the sheets was booked with them.
void EnergyLedger::book_sheets(const World& world, const edge::WorkOnSheets& work, double dt) {
  losses_.edge -= work.edge;
  for (const ContactLoad& contact : world.contacts_of_sheets()) {
    book(losses_, contact, dt);
    taken_.contacts += contact.loss;
  }
  losses_.drag -= work.form + work.wind;
  losses_.skin_friction -= work.skin;
}

void EnergyLedger::remove(const World& world, const floes::FloePopulation& floes, BodyId body) {
  removed_ += floes.energy(world, body, floes.at(body));
}

void EnergyLedger::add_piece(const World& world, const floes::FloePopulation& floes, BodyId body) {
  removed_ -= floes.energy(world, body, floes.at(body));
}

void EnergyLedger::report(const World& world, const floes::FloePopulation& floes, model::LoadRow& row,
                          double in_sheets) const {
  row.kinetic_energy = world.kinetic_energy() + in_sheets;
  row.potential_energy = floes.potential_energy(world);
  row.work = work_;
  row.birth_energy = birth_;
  row.removed_energy = removed_;
  row.losses = losses_;
  row.energy_error = work_ + birth_ - row.kinetic_energy - row.potential_energy - losses_.total() - removed_;
}

}  // namespace brash::simulation
