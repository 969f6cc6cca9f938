// SPDX-License-Identifier: GPL-3.0-or-later
#include "energy_ledger.hpp"

namespace brash::simulation {
namespace {

using rigid_body::BodyKind;
using rigid_body::ContactLoad;
using rigid_body::World;

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

void EnergyLedger::book_step(const World& world, const FloePopulation& floes, std::int64_t first_newborn, double dt) {
  taken_ = {};
  for (const BodyId body : world.moving()) received_[body] = 0.0;
  for (const ContactLoad& contact : world.contacts()) {
    book(losses_, contact, dt);
    taken_.contacts += contact.loss;
    const Vec3 force = contact.normal_force * contact.normal + contact.friction_force;
    received_[contact.body] += dt * dot(force, contact.body_velocity);
    if (contact.other_kind == BodyKind::kFloe) received_[contact.other] -= dt * dot(force, contact.other_velocity);
  }
  for (const BodyId body : world.moving()) {
    const Floe& floe = floes.at(body);
    const Twist twist = world.mean_twist(body);
    const double drag = dt * power(floe.drag, twist);
    const double skin_friction = dt * power(floe.skin_friction, twist);
    const double pressure = dt * power(floe.pressure, twist) + world.gained_by_turning(body);
    taken_.water += floe.shed;
    taken_.water -=
        dt * (power(floe.drag, world.loaded_twist(body)) + power(floe.skin_friction, world.start_twist(body)));
    losses_.drag += floe.shed - drag - pressure;
    losses_.skin_friction -= skin_friction;
    received_[body] += drag + skin_friction - floe.shed + pressure;
    if (floe.id >= first_newborn) birth_ += floes.energy(world, body, floe) - received_[body];
  }
}

/// docs/theory/free-sheet.md, (G5). What contacts with floes gave the sheets was booked with them.
void EnergyLedger::book_sheets(const World& world, const WorkOnSheets& work, double dt) {
  losses_.edge -= work.edge;
  for (const ContactLoad& contact : world.contacts_of_sheets()) {
    book(losses_, contact, dt);
    taken_.contacts += contact.loss;
  }
  losses_.drag -= work.form + work.wind;
  losses_.skin_friction -= work.skin;
}

void EnergyLedger::remove(const World& world, const FloePopulation& floes, BodyId body) {
  received_.erase(body);
  removed_ += floes.energy(world, body, floes.at(body));
}

void EnergyLedger::add_piece(const World& world, const FloePopulation& floes, BodyId body) {
  removed_ -= floes.energy(world, body, floes.at(body));
}

void EnergyLedger::report(const World& world, const FloePopulation& floes, model::LoadRow& row,
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
