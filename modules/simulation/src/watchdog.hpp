// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "brash/geometry/ledger.hpp"
#include "brash/model/case.hpp"
#include "brash/model/records.hpp"
#include "brash/rigid_body/world.hpp"
#include "energy_ledger.hpp"
#include "floe_population.hpp"

namespace brash::simulation {

/// A state after a step, with the accounts kept of it.
struct Watched {
  const rigid_body::World& world;
  const FloePopulation& floes;
  const EnergyLedger& energy;
  const geometry::Ledger& area;
  const model::LoadRow& row;  ///< what the step reports
  Taken taken;
};

/// Ends a run whose numbers cannot be physics before anyone takes them for a result (docs/theory/simulation.md). It
/// only looks; nothing in a run depends on it.
class Watchdog {
 public:
  explicit Watchdog(const model::Case& resolved);

  /// Takes the state before the first step, or that of a checkpoint, as the start.
  void begin(const Watched& start);
  /// @throws RunError naming the floe or the account and the numbers that do not fit.
  void look(const Watched& now);

 private:
  /// What the integration in time may leave open of the energy of floes of this weight [N], in J: dt F (u' - u) / 2 of
  /// what is constant in F adds up to no more than half of it along one step's travel (docs/theory/dynamics.md,
  /// Energy); F is the weight, or the lift under water where that is more.
  double allowance(double weight) const { return 0.5 * most_lift_ * weight * travel_; }
  double impulses(const rigid_body::World& world) const;

  void look_at_place(const Floe& floe, Vec3 place, double time) const;
  void look_at_energy(const Watched& now, BodyId body, const Floe& floe);
  void look_at_losses(const Watched& now) const;
  void look_at_balance(const Watched& now) const;

  const model::Case* case_;
  double travel_;                       ///< [m]
  double most_lift_;                    ///< F over the weight
  double booked_error_ = 0.0;           ///< of the energies at the start [J]
  std::map<BodyId, double> explained_;  ///< energy of each floe that its work explains [J]
};

}  // namespace brash::simulation
