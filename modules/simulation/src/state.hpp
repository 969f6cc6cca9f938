// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "brash/core/workers.hpp"
#include "brash/edge/drifting_sheets.hpp"
#include "brash/edge/edge_contact.hpp"
#include "brash/edge/moving_edges.hpp"
#include "brash/edge/sheet_tiles.hpp"
#include "brash/edge/verdicts.hpp"
#include "brash/floes/bearings.hpp"
#include "brash/floes/coverage.hpp"
#include "brash/floes/floe_bending.hpp"
#include "brash/floes/floe_population.hpp"
#include "brash/floes/floe_water.hpp"
#include "brash/floes/sleep.hpp"
#include "brash/ice/crack_pattern.hpp"
#include "brash/ice/field.hpp"
#include "brash/model/checkpoint.hpp"
#include "brash/simulation/simulation.hpp"
#include "energy_ledger.hpp"
#include "region_loads.hpp"
#include "stage_timer.hpp"
#include "watchdog.hpp"

namespace brash::simulation {

/// What stays as it is in a run: the case, and objects made once from it.
struct Laws {
  explicit Laws(const model::Case& c);

  model::Case resolved;
  std::unique_ptr<const structure::Hull> hull;
  double hull_reach;                                ///< from the origin of the structure to its farthest point [m]
  std::optional<const structure::Regions> regions;  ///< of the structure, for its loads
  std::optional<const floes::Coverage> coverage;    ///< of the regions of a hull
  std::unique_ptr<const ice::CrackPattern> pattern;
  floes::FloeWater water;
  floes::StressLaw stress;
};

/// All that the next step depends on. What a checkpoint holds of it: checkpoint_of(); the rest is made again.
struct State {
  /// Level ice as laid, the structure at its start, no floes.
  State(const Laws& laws, ice::Field laid, Workers& workers);
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  std::int64_t n_steps = 0;
  std::uint64_t n_breaks = 0;  ///< keys the random stream of each break
  std::unique_ptr<structure::Motion> motion;
  ice::Field field;
  edge::MovingEdges edges;
  edge::Verdicts verdicts;
  rigid_body::World world;
  edge::DriftingSheets sheets;
  floes::FloePopulation floes;
  floes::Bearings bearings;
  floes::FloeBending bending;
  floes::Sleep sleep;
  EnergyLedger energy;
  Watchdog watchdog;

  // Made again from the above.
  BodyId structure_body;
  std::vector<geometry::Extent> borders;  ///< around each wall and each part of a shore
  edge::SheetTiles tiles;
  std::vector<std::shared_ptr<const failure::BendingCriterion>> criteria;  ///< of each level ice

  double time(const Laws& laws) const { return static_cast<double>(n_steps) * laws.resolved.time.step; }

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("n_steps", "1", "steps done", self.n_steps);
    visit("n_breaks", "1", "random streams used", self.n_breaks);
  }
};

/// Level ice that has just broken off.
struct BrokenIce {
  int level_ice = 0;
  Vec2 centre{};  ///< in the frame of its sheet [m]
  double reach = 0.0;
  std::vector<geometry::Extent> severed;  ///< ice that lost its hold beyond the crack, in the same frame
};

/// A step while it is taken: its report, and the data that one stage leaves to another.
struct Step {
  explicit Step(const Laws& laws) : region_loads(laws.regions) {}

  StepReport report;
  Pose start{};                    ///< of the structure when the contacts of bodies are found
  Wrench crushing{};               ///< load of the crushed edge on the structure, mean of the parts, sheet axes
  std::int64_t first_newborn = 0;  ///< floes from this id on were born in the step
  std::vector<BrokenIce> broken;
  RegionLoadSums region_loads;
  StageTimer timer;
};

/// The laws of contact of a case.
rigid_body::WorldSettings world_settings(const model::Case& c);

/// The criterion of more level ice; ice of the same kind shares one.
void add_criterion(State& s, const Laws& laws, const ice::Plate& plate);

model::Checkpoint checkpoint_of(const State& s, const Laws& laws);
/// Takes a run up where `checkpoint` left it.
void restore(State& s, const Laws& laws, const model::Checkpoint& checkpoint);
/// The ice of a checkpoint.
/// @throws InputError unless it is of this case; the name may differ.
ice::Field field_of(const model::Case& resolved, const model::Checkpoint& checkpoint);

}  // namespace brash::simulation
