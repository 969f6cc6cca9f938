// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "brash/model/checkpoint.hpp"
#include "brash/simulation/simulation.hpp"
#include "edge_contact.hpp"
#include "energy_ledger.hpp"
#include "floe_population.hpp"
#include "ice_field.hpp"
#include "sheet_tiles.hpp"
#include "stage_timer.hpp"
#include "watchdog.hpp"

namespace brash::simulation {

struct Simulation::Impl {
  model::Case resolved;
  StageTimes times;
  StageTimer timer;
  failure::IceProperties ice;
  structure::Cone cone;
  std::unique_ptr<failure::BendingCriterion> criterion;
  IceField field;
  rigid_body::World world;
  SheetTiles tiles;
  FloePopulation floes;
  BodyId structure_body;
  Vec2 centre;  ///< of the structure [m]
  std::int64_t n_steps = 0;
  std::uint64_t n_breaks = 0;  ///< keys the random stream of each break
  EnergyLedger energy;
  Watchdog watchdog;
  std::vector<model::FloeRecord> initial_births;

  /// Lays the sheet, cuts the initial crack and places the structure.
  explicit Impl(const model::Case& c);
  /// Takes a run up where `checkpoint` left it.
  Impl(const model::Case& c, const model::Checkpoint& checkpoint);

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("n_steps", "1", "steps done", self.n_steps);
    visit("n_breaks", "1", "random streams used", self.n_breaks);
    visit("centre_", "m", "place of the structure", self.centre);
  }

  double time() const { return static_cast<double>(n_steps) * resolved.time.step; }
  Pose structure_pose() const { return {{centre.x, centre.y, 0.0}, {}}; }
  EdgeModel edge_model() const { return {cone, resolved, ice, *criterion}; }

  int draw_wedges();
  void initial_crack();
  /// The state as it is becomes what the watchdog starts from.
  void begin_watch();
  std::vector<model::FloeRecord> break_off(Vec2 at, double radius, int n_wedges, StepReport& report);
  void advance_through_ice(StepReport& report);
  std::vector<EdgeContact> move_within_range(double& share, StepReport& report);
  bool crush_passed_ice();
  std::vector<EdgeContact> contacts_of_floes(StepReport& report) const;
  void break_ice(const std::vector<EdgeContact>& contacts, StepReport& report);
  void lay_sheet_near(BodyId body);
  void remove_crushed_floes(StepReport& report);
  void collect_loads(std::int64_t first_newborn, Vec3 origin, StepReport& report);
  StepReport step();
  model::Checkpoint checkpoint() const;

 private:
  Impl(const model::Case& c, IceField laid);
};

}  // namespace brash::simulation
