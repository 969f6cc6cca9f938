// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/floes/floe_stress.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "brash/floes/floe_population.hpp"

namespace brash::floes {
namespace {

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

/// The stress of the last step, from its dipole, into the mean.
void add_to_mean(Floe& floe, const StressLaw& law, double dt) {
  const double volume = floe.area.square_metres() * floe.prism.thickness;
  const double share = law.averaged ? averaging_share(floe, dt) : 1.0;
  MeanStress& stress = floe.stress;
  for (std::size_t i = 0; i < 6; ++i) stress.now[i] += share * (floe.dipole[i] / volume - stress.now[i]);
  floe.compression = law.of_contacts ? floe.contact_pressure : largest_compression(stress.now);
  stress.peak_compression = std::max(stress.peak_compression, floe.compression);
}

/// The largest normal force between a floe and another body over the area of their contact, of each floe.
void find_contact_pressures(const std::vector<const rigid_body::ContactLoad*>& contacts, FloePopulation& floes) {
  struct Contact {
    double normal_force = 0.0, area = 0.0;
  };
  std::map<std::pair<BodyId, BodyId>, Contact> pairs;
  for (const rigid_body::ContactLoad* const point : contacts) {
    Contact& contact = pairs[{point->body, point->other}];
    contact.normal_force += point->normal_force;
    contact.area += point->area;
  }
  for (const auto& [pair, contact] : pairs) {
    if (!(contact.area > 0.0)) continue;
    for (const BodyId body : {pair.first, pair.second}) {
      if (!floes.contains(body)) continue;
      double& largest = floes.at(body).contact_pressure;
      largest = std::max(largest, contact.normal_force / contact.area);
    }
  }
}

}  // namespace

std::vector<const rigid_body::ContactLoad*> contacts_by_place(const rigid_body::World& world) {
  std::vector<const rigid_body::ContactLoad*> contacts;
  for (const rigid_body::ContactLoad& contact : world.contacts()) contacts.push_back(&contact);
  std::ranges::sort(contacts, {}, [](const rigid_body::ContactLoad* c) {
    return std::tie(c->point.x, c->point.y, c->point.z, c->normal.x, c->normal.y, c->normal.z);
  });
  return contacts;
}

void update_stress(const rigid_body::World& world, const std::vector<const rigid_body::ContactLoad*>& contacts,
                   const StressLaw& law, double dt, FloePopulation& floes) {
  for (const BodyId body : world.moving()) {
    floes.at(body).dipole = {};
    floes.at(body).contact_pressure = 0.0;
  }
  for (const rigid_body::ContactLoad* const contact : contacts) {
    const Vec3 force = contact->normal_force * contact->normal + contact->friction_force;
    add_dipole(floes.at(contact->body).dipole, contact->point - world.start_pose(contact->body).position, force);
    if (contact->other_kind == rigid_body::BodyKind::kFloe)
      add_dipole(floes.at(contact->other).dipole, contact->point - world.start_pose(contact->other).position, -force);
  }
  if (law.of_contacts) find_contact_pressures(contacts, floes);
  const std::vector<BodyId>& moving = world.moving();
  world.workers().each(moving.size(), kCheapFloes, [&](std::size_t i) { add_to_mean(floes.at(moving[i]), law, dt); });
}

std::vector<BodyId> overstressed(const rigid_body::World& world, const FloePopulation& floes, double strength) {
  std::vector<BodyId> bodies;
  for (const BodyId body : world.moving())
    if (floes.at(body).compression > strength) bodies.push_back(body);
  return bodies;
}

}  // namespace brash::floes
