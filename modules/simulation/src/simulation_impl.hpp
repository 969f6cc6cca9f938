// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "bearings.hpp"
#include "brash/core/workers.hpp"
#include "brash/ice/crack_pattern.hpp"
#include "brash/ice/field.hpp"
#include "brash/model/checkpoint.hpp"
#include "brash/simulation/simulation.hpp"
#include "drifting_sheets.hpp"
#include "edge_contact.hpp"
#include "energy_ledger.hpp"
#include "floe_bending.hpp"
#include "floe_population.hpp"
#include "floe_water.hpp"
#include "moving_edges.hpp"
#include "region_loads.hpp"
#include "sheet_tiles.hpp"
#include "sleep.hpp"
#include "stage_timer.hpp"
#include "verdicts.hpp"
#include "watchdog.hpp"

namespace brash::simulation {

/// The result of a break.
struct Break {
  int n_wedges = 0;
  bool along_stress = false;
  std::vector<model::FloeRecord> births;
};

/// Level ice that has just broken off.
struct BrokenIce {
  int level_ice = 0;
  Vec2 centre{};  ///< in the frame of its sheet [m]
  double reach = 0.0;
  std::vector<geometry::Extent> severed;  ///< ice that lost its hold beyond the crack, in the same frame
};

struct Simulation::Impl {
  model::Case resolved;
  StageTimes times;
  StageTimer timer;
  std::unique_ptr<const structure::Hull> hull;
  std::unique_ptr<structure::Motion> motion;
  ice::Field field;
  double hull_reach;  ///< from the origin of the structure to its farthest point [m]
  std::vector<std::shared_ptr<const failure::BendingCriterion>> criteria;  ///< of each level ice
  MovingEdges edges;
  Verdicts verdicts;
  std::unique_ptr<ice::CrackPattern> pattern;
  Workers workers;
  rigid_body::World world;
  std::vector<geometry::Extent> borders;  ///< around each wall and each part of a shore
  DriftingSheets sheets;
  SheetTiles tiles;
  FloePopulation floes;
  FloeWater water;
  Bearings bearings;
  FloeBending bending;
  Sleep sleep;
  BodyId structure_body;
  RegionLoadSums region_loads;
  std::int64_t n_steps = 0;
  std::uint64_t n_breaks = 0;  ///< keys the random stream of each break
  EnergyLedger energy;
  Watchdog watchdog;
  std::vector<model::FloeRecord> initial_births;
  std::vector<BrokenIce> broken_in_step;

  /// Lays the sheet, cuts the initial crack and places the structure.
  Impl(const model::Case& c, int threads);
  /// Takes a run up where `checkpoint` left it.
  Impl(const model::Case& c, const model::Checkpoint& checkpoint, int threads);

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("n_steps", "1", "steps done", self.n_steps);
    visit("n_breaks", "1", "random streams used", self.n_breaks);
  }

  double time() const { return static_cast<double>(n_steps) * resolved.time.step; }
  EdgeModel edge_model(const ice::Plate& plate) const;

  void initial_crack();
  /// The floes that are there at the start.
  void lay_floes();
  /// The watchdog starts from the present state.
  void begin_watch();

  StepReport step();
  Wrench advance_through_ice(StepReport& report);
  void load_by_water(const Pose& start);
  void step_bodies(StepReport& report);
  Wrench collect_loads(std::int64_t first_newborn, const Pose& start, const Wrench& crushing, StepReport& report);
  void report_motion(model::LoadRow& row) const;
  void watch(const StepReport& report);
  void fall_asleep_or_wake();
  void average_contacts();
  void remove_crushed_floes(StepReport& report);
  void split_floes(StepReport& report);
  void split(const Fracture& fracture, StepReport& report);

  std::vector<EdgeContact> move_within_limits(double& share, double done, StepReport& report);
  std::vector<EdgeContact> contacts_at(const structure::State& state, double later, double time) const;
  /// Calls `use(plate, contacts with it)` for each level ice; the contacts are sorted by it then.
  template <class Use>
  void for_each_sheet(std::vector<EdgeContact>& contacts, const Use& use) const {
    std::vector<EdgeContact> sorted;
    for (const ice::Plate& plate : field.level_ice()) {
      std::vector<EdgeContact> here;
      for (EdgeContact& contact : contacts)
        if (contact.level_ice == plate.level_ice()) here.push_back(std::move(contact));
      std::erase_if(contacts, [&](const EdgeContact& contact) { return contact.level_ice == plate.level_ice(); });
      use(plate, here);
      std::ranges::move(here, std::back_inserter(sorted));
    }
    contacts = std::move(sorted);
  }
  void weigh_loads(std::vector<EdgeContact>& contacts) const;
  std::vector<double> work_on(const std::vector<EdgeContact>& contacts, double seconds) const;
  void add_contacts_of_floes(std::vector<EdgeContact>& contacts) const;
  void judge(std::vector<EdgeContact>& contacts, double now, StepReport& report);
  bool crush_passed_ice(double time, StepReport& report);
  geometry::Extent release_severed(int level_ice, const Pose& structure, StepReport& report);
  void break_ice(const std::vector<EdgeContact>& contacts, StepReport& report);
  bool has_broken(const EdgeContact& contact) const;
  Break break_off(const EdgeContact& contact, StepReport& report);
  void let_go(int level_ice, const geometry::Extent& box);
  void let_float(ice::Plate&& piece, int level_ice, std::vector<model::FloeRecord>& births, StepReport& report);
  void add_judge(const ice::Plate& plate);
  void follow_outline(const ice::Plate& plate, const geometry::Extent& changed);
  void lay_sheets_that_meet();
  void hand_over_sheets();
  void take_back_sheets();
  bool is_near(const ice::Plate& plate, const structure::State& seen) const;
  void split_sheets(const std::vector<EdgeContact>& contacts, StepReport& report);
  void release_small_sheets(StepReport& report);
  model::CrackEvent in_world(int level_ice, model::CrackEvent event) const;
  void expect_on_the_plane() const;
  void lay_sheet_near(BodyId body);
  Clear clear_of_structure(bool fall) const;
  void begin_asleep();
  std::vector<geometry::Polygon> outlines_in_world() const;
  model::Checkpoint checkpoint() const;

 private:
  Impl(const model::Case& c, ice::Field laid, int threads);
};

}  // namespace brash::simulation
