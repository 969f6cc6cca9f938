// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "brash/geometry/ledger.hpp"
#include "brash/geometry/polygon.hpp"
#include "brash/model/case.hpp"
#include "brash/model/checkpoint.hpp"
#include "brash/model/records.hpp"
#include "brash/model/warning.hpp"
#include "brash/structure/motion.hpp"

namespace brash::simulation {

/// A floe that a step deleted, and why.
struct FloeDeath {
  std::int64_t floe = 0;
  model::FloeEnd cause = model::FloeEnd::kCrushed;
  double peak_stress = 0.0;  ///< over its life [Pa]
};

/// How breaks were decided: each counts in every line that holds for it.
struct BreakCounts {
  int under_floes = 0;   ///< a floe pressed on the ice
  int radial_first = 0;  ///< a radial crack had split the sheet
  int true_edge = 0;     ///< checked on the sheet with its true edge; the others on a trapezoid
  int along_stress = 0;  ///< the crack followed the stress; the others cut a disc
  int buckled = 0;       ///< the sheet buckled under its in-plane load
  int sheets_split = 0;  ///< besides: drifting sheets that split in their plane

  BreakCounts& operator+=(const BreakCounts& other);

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("under_floes", "1", "breaks under floes", self.under_floes);
    visit("radial_first", "1", "breaks of a sheet that a radial crack had split", self.radial_first);
    visit("true_edge", "1", "breaks on the true edge", self.true_edge);
    visit("along_stress", "1", "breaks whose crack followed the stress", self.along_stress);
    visit("buckled", "1", "breaks of a sheet that buckled", self.buckled);
    visit("sheets_split", "1", "drifting sheets that split in their plane", self.sheets_split);
  }
};

/// Where the wall time went, by stage [s]; no part of it is counted twice.
struct StageTimes {
  double contacts = 0.0;   ///< where structure and floes meet the edge, and the wedges fitted there
  double failure = 0.0;    ///< the bending criterion
  double cutting = 0.0;    ///< cracks, crushing and the collision shapes after them
  double water = 0.0;      ///< weight, buoyancy and drag
  double world = 0.0;      ///< rigid bodies and their contacts
  double loads = 0.0;      ///< sums by cause, energies, watchdogs
  double recording = 0.0;  ///< frames, checkpoints, and writing the results

  StageTimes& operator+=(const StageTimes& other);
};

/// Visits every stage with its name.
template <typename Times, typename Visitor>
void visit_stages(Times& times, Visitor&& visit) {
  visit("contacts", times.contacts);
  visit("failure", times.failure);
  visit("cutting", times.cutting);
  visit("water", times.water);
  visit("world", times.world);
  visit("loads", times.loads);
  visit("recording", times.recording);
}

/// The report of one step.
struct StepReport {
  model::LoadRow loads;
  std::vector<model::CrackEvent> events;
  std::vector<model::SheetSplit> splits;
  std::vector<model::FloeRecord> births;
  std::vector<FloeDeath> deaths;
  int n_substeps = 1;  ///< parts the structure's move was cut into (Sec. 2.2.2)
  BreakCounts breaks;
  model::SheetSolves sheets;  ///< of all verdicts
  model::KeptCounts verdicts;
  int n_below_range = 0;     ///< assessments with an input clamped up to the failure model's range
  int n_above_range = 0;     ///< assessments that stayed above the range at the shortest substep
  int n_steps_too_long = 0;  ///< births with T_col (Eqs. 11, 12) below the time step
  double last_change = 0.0;  ///< rigid_body::World::last_change() [m/s]
  StageTimes times;
};

/// One structure driving into one ice sheet: the paper's algorithm.
class Simulation {
 public:
  /// Lays the sheet, cuts the initial crack and places the structure.
  /// @param threads  that share out the loops over floes and contacts, the calling one among them, >= 1. Results do not
  ///                 depend on their number.
  /// @throws InputError when the failure model cannot be read.
  explicit Simulation(const model::Case& resolved, int threads = 1);
  /// Takes a run of the same case up where `checkpoint` left it; it continues as if it had not been interrupted.
  /// @throws InputError when the checkpoint is of another case.
  Simulation(const model::Case& resolved, const model::Checkpoint& checkpoint, int threads = 1);
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;
  ~Simulation();

  /// Says where the structure goes in the next step, with structure.motion.kind = "driven": to `goal.pose`, straight
  /// and with an even turn. Contacts see it move at `goal.twist`, which should be the mean velocity of that way.
  /// Without a call the structure continues at its last twist. A second call before the step replaces the first.
  /// @param goal  pose of the hull's frame, and the twist of its origin, sheet frame [m], [m/s], [rad/s].
  /// @throws InputError when the case has another motion, or a value is not finite or no rotation.
  void drive(const structure::State& goal);
  /// The same to a pose, at the mean velocity of the way there; and on at a twist, to where it leads in a step.
  void drive(const Pose& goal);
  void drive(const Twist& twist);
  /// Where the structure is, and how it moved in the last step.
  const structure::State& structure() const;

  /// Advances by one time step.
  /// @throws RunError when the result can be no physics; the simulation is then of no further use.
  [[nodiscard]] StepReport step();

  /// All that the next step depends on; `results` is left to the caller.
  model::Checkpoint checkpoint() const;

  double time() const;
  /// Floes made by the initial crack, before the first step.
  const std::vector<model::FloeRecord>& initial_births() const;
  std::vector<geometry::Polygon> sheet() const;
  /// The sheets with free borders, those that are no more with no mass; none where borders are fixed.
  std::vector<model::SheetMotion> sheet_motions() const;
  const geometry::Ledger& ledger() const;
  /// Poses of structure and floes, now.
  model::Frame frame() const;
  /// Largest mean compression so far of each floe present, by its id [Pa].
  std::vector<std::pair<std::int64_t, double>> peak_stresses() const;
  const StageTimes& stage_times() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace brash::simulation
