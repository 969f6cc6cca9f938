// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "brash/model/case.hpp"
#include "brash/rigid_body/world.hpp"

namespace brash::floes {

class FloePopulation;

/// Mean stress of a floe from its contact forces (Love-Weber), as StressLaw averages it; tension positive.
struct MeanStress {
  std::array<double, 6> now{};    ///< xx, yy, zz, xy, yz, zx [Pa]
  double peak_compression = 0.0;  ///< largest compression so far that StressLaw compares with the strength [Pa]

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("stress_xx", "Pa", "mean stress", self.now[0]);
    visit("stress_yy", "Pa", "mean stress", self.now[1]);
    visit("stress_zz", "Pa", "mean stress", self.now[2]);
    visit("stress_xy", "Pa", "mean stress", self.now[3]);
    visit("stress_yz", "Pa", "mean stress", self.now[4]);
    visit("stress_zx", "Pa", "mean stress", self.now[5]);
    visit("peak_stress", "Pa", "largest compression so far", self.peak_compression);
  }
};

/// The stress that decides whether a floe is crushed; contact.floe_stress.
struct StressLaw {
  explicit StressLaw(const model::ContactSection& contact)
      : averaged(contact.floe_stress == model::FloeStress::kAveraged),
        of_contacts(contact.floe_stress == model::FloeStress::kContact) {}

  bool averaged;     ///< over the collision time T_col; else it is of the last step
  bool of_contacts;  ///< the largest normal force of a contact over its area; else the mean over the floe
};

/// The contacts of the world's last step, sorted by their places: sums over them do not depend on the bodies' ids.
std::vector<const rigid_body::ContactLoad*> contacts_by_place(const rigid_body::World& world);

/// Takes the contacts of a step of `dt` [s] into the stress of every floe that is awake.
/// @param contacts  contacts_by_place().
void update_stress(const rigid_body::World& world, const std::vector<const rigid_body::ContactLoad*>& contacts,
                   const StressLaw& law, double dt, FloePopulation& floes);

/// Floes that are awake and whose compressive stress exceeds `strength` [Pa], sorted by body.
std::vector<BodyId> overstressed(const rigid_body::World& world, const FloePopulation& floes, double strength);

}  // namespace brash::floes
