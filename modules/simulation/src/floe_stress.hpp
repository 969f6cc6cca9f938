// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "brash/rigid_body/world.hpp"

namespace brash::simulation {

class FloePopulation;

/// Mean stress of a floe from its contact forces (Love-Weber), averaged over its collision time T_col; tension
/// positive.
struct MeanStress {
  std::array<double, 6> now{};    ///< xx, yy, zz, xy, yz, zx [Pa]
  double peak_compression = 0.0;  ///< largest principal compression so far [Pa]

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

/// The contacts of the world's last step, sorted by their places: sums over them do not depend on the bodies' ids.
std::vector<const rigid_body::ContactLoad*> contacts_by_place(const rigid_body::World& world);

/// Averages the stress of every floe that is awake over a step of `dt` [s].
/// @param contacts  contacts_by_place().
void average_stress(const rigid_body::World& world, const std::vector<const rigid_body::ContactLoad*>& contacts,
                    double dt, FloePopulation& floes);

/// Floes that are awake and whose mean compressive stress exceeds `strength` [Pa], sorted by body.
std::vector<BodyId> overstressed(const rigid_body::World& world, const FloePopulation& floes, double strength);

}  // namespace brash::simulation
