// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <map>
#include <utility>

#include "brash/floes/floe_population.hpp"
#include "brash/geometry/ledger.hpp"
#include "brash/model/case.hpp"
#include "brash/model/checkpoint.hpp"
#include "brash/model/records.hpp"
#include "brash/rigid_body/world.hpp"
#include "energy_ledger.hpp"

namespace brash::simulation {

/// A state after a step, with the accounts kept of it.
struct Watched {
  const rigid_body::World& world;
  const floes::FloePopulation& floes;
  const EnergyLedger& energy;
  const geometry::Ledger& area;
  const model::LoadRow& row;  ///< the load row of the step
  Taken taken;
  Twist structure;  ///< the structure's motion in the step
};

/// Ends a run whose numbers cannot be physics before anyone takes them for a result (docs/theory/simulation.md). It
/// only looks; nothing in a run depends on it.
class Watchdog {
 public:
  /// @param hull  the structure's least and largest coordinates, its frame [m].
  Watchdog(const model::Case& resolved, const std::pair<Vec3, Vec3>& hull);

  /// Takes the state before the first step as the start.
  /// @param births  what the first step will book as born: the energy of the floes that are there [J].
  void begin(const Watched& start, double births = 0.0);
  /// @throws RunError naming the floe or the account and the numbers that do not fit.
  void look(const Watched& now);

  /// The floe `body` was born with `energy` [J] when `parent` broke: it is explained by what explained the parent's.
  void add_piece(double energy, BodyId body, BodyId parent);

  /// A floe of this weight [N] has gone. What the time step explains of its energy still counts in the balance.
  void remove(BodyId body, double weight);

  void save(const floes::FloePopulation& floes, model::Checkpoint& checkpoint) const;
  /// Continues with the accounts of an earlier run, so that it passes or ends a resumed run as it would the whole one.
  void restore(const floes::FloePopulation& floes, const model::Checkpoint& checkpoint);

  /// The members that are not of one floe.
  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("travel", "m", "longest travel that structure, rise and current give in a step", self.travel_);
    visit("booked_error", "J", "error of the energies at the start", self.booked_error_);
    visit("gyroscopic", "J", "energy that loads and contacts gave through gyroscopic moments", self.gyroscopic_);
    visit("allowed_to_gone", "J", "error that the time step may have left in floes that have gone",
          self.allowed_to_gone_);
  }

 private:
  /// Largest error that the integration in time may leave in the energy of floes of this weight [N], in J. The constant
  /// part of F gives dt F (u' - u) / 2 a step. These add up to no more than half the work of F along one step's travel
  /// (docs/theory/contacts-and-bodies.md, Energy). F is the weight, or the lift under water where the lift is more.
  /// @param travel  longest travel of the floe in a step [m].
  double allowance(double weight, double travel) const { return 0.5 * most_lift_ * weight * std::max(travel, travel_); }
  /// Summed up until it is `enough` [J].
  double allowance_of_all(const floes::FloePopulation& floes, double enough) const;
  /// Of a floe.
  struct Account {
    double explained = 0.0;  ///< energy that its work explains [J]
    double travel = 0.0;     ///< longest in a step [m]
  };

  void see_structure(const Twist& twist);
  void open_accounts(const floes::FloePopulation& floes);
  double impulses(const rigid_body::World& world) const;

  void look_at_place(const floes::Floe& floe, Vec3 place, double time) const;
  void look_at_energy(const Watched& now, BodyId body, const floes::Floe& floe);
  void explain_gyration(const rigid_body::World& world);
  void look_at_losses(const Watched& now) const;
  void look_at_balance(const Watched& now) const;

  const model::Case* case_;
  std::pair<Vec3, Vec3> hull_;    ///< least and largest coordinates, its frame [m]
  double travel_ = 0.0;           ///< that structure, rise and current give in a step, at most until now [m]
  double most_lift_;              ///< F over the weight
  double booked_error_ = 0.0;     ///< of the energies at the start [J]
  double gyroscopic_ = 0.0;       ///< World::gyroscopic_share() of all floes and steps [J]
  double allowed_to_gone_ = 0.0;  ///< allowances of the floes that have gone [J]
  std::map<BodyId, Account> accounts_;
  std::int64_t next_id_ = 0;  ///< floes with lower ids have had their accounts opened
};

}  // namespace brash::simulation
