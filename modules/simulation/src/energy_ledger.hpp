// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "brash/edge/drifting_sheets.hpp"
#include "brash/floes/floe_population.hpp"
#include "brash/model/records.hpp"
#include "brash/rigid_body/world.hpp"

namespace brash::simulation {

/// Energies taken in a step, which cannot be negative [J] (docs/theory/contacts-and-bodies.md, (E4)).
struct Taken {
  double contacts = 0.0;  ///< by all contacts, from the energy that the loads left
  double water = 0.0;     ///< by drag and skin friction at the velocities that they were made for; in water at rest
};

/// Work of the water and the air on a floe in a step [J].
struct WorkOfWater {
  double drag = 0.0;
  double skin_friction = 0.0;
  double pressure = 0.0;
  double taken = 0.0;  ///< against Taken::water, by drag and skin friction
};

/// Where the structure's work goes: sums since the start of the run, each from loads and the mean velocities of the
/// step (docs/theory/contacts-and-bodies.md, (E1), (E3)). It only looks; nothing in a run depends on it.
class EnergyLedger {
 public:
  /// The ice moved by `passage` past the structure [m], [rad], under the loads `edge` of the sheet's edge and `floes`
  /// on it; all in the same axes.
  void book_structure(const Wrench& edge, const Wrench& floes, const Twist& passage);

  /// Contacts and water in the world's last step, `dt` [s] long. Floes from id `first_newborn` on were born before it.
  /// Afterwards received() holds the energy that the step gave each moving floe.
  void book_step(const rigid_body::World& world, const floes::FloePopulation& floes, std::int64_t first_newborn,
                 double dt);

  /// The floe `body` is about to be deleted.
  void remove(const rigid_body::World& world, const floes::FloePopulation& floes, BodyId body);

  /// Of the structure's work on the edge, this bent edges [J]. The edge keeps none of it: it goes into the water with
  /// the waves of the ice, and into new cracks.
  void book_bent_edges(double work);

  /// Work of the step on drifting sheets: the loads of the structure gave it to their kinetic energy, and water, wind
  /// and the contacts between sheets took some. Call after book_structure() and book_step(), `dt` as there.
  void book_sheets(const rigid_body::World& world, const edge::WorkOnSheets& work, double dt);

  /// Of the structure's work on the edge, this moved a sheet [J].
  void book_pushed_sheet(double work) { losses_.edge -= work; }

  /// Drifting sheets begin the run with this kinetic energy, which a current gives [J].
  void book_drift_at_start(double kinetic) { birth_ += kinetic; }

  /// Drifting sheets have lost or, negative, received this kinetic energy with ice that came or went [J].
  void book_left_sheets(double kinetic) { removed_ += kinetic; }

  /// The floe `body` is a piece of one that has been removed, and keeps its part of the energy.
  void add_piece(const rigid_body::World& world, const floes::FloePopulation& floes, BodyId body);

  /// Floes have lost `kinetic` [J] by falling asleep.
  void book_fallen_asleep(double kinetic) { removed_ += kinetic; }

  /// Work of contacts and drag on a moving floe in the last step [J]; weight and buoyancy are its potential energy.
  double received(BodyId body) const { return received_[body.index]; }

  /// By contacts and water in the last step.
  const Taken& taken() const { return taken_; }

  /// Fills the energies of a row.
  /// @param in_sheets  kinetic energy of drifting sheets [J].
  void report(const rigid_body::World& world, const floes::FloePopulation& floes, model::LoadRow& row,
              double in_sheets = 0.0) const;

  /// Every sum.
  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("work", "J", "work of the structure", self.work_);
    visit("birth_energy", "J", "energy of floes at their birth", self.birth_);
    visit("removed_energy", "J",
          "energy of floes that were deleted or fell asleep, of brash, and of ice that left drifting sheets",
          self.removed_);
    model::EnergyLosses::visit([&](const char* cause, const char* meaning, double model::EnergyLosses::*loss) {
      visit(cause, "J", meaning, self.losses_.*loss);
    });
  }

 private:
  double work_ = 0.0;
  double birth_ = 0.0;
  double removed_ = 0.0;
  model::EnergyLosses losses_;
  std::vector<double> received_;         ///< by the index of the body
  std::vector<WorkOfWater> from_water_;  ///< of the moving floes
  Taken taken_;
};

}  // namespace brash::simulation
