// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "brash/model/checkpoint.hpp"
#include "brash/model/origin.hpp"
#include "brash/model/records.hpp"
#include "brash/model/warning.hpp"
#include "brash/simulation/simulation.hpp"
#include "brash/statistics/summary.hpp"

namespace brash::simulation {

/// Mean load by cause [N].
struct LoadSplit {
  double crushing = 0.0;
  double floe_normal = 0.0;
  double floe_friction = 0.0;
};

/// Mean load by region of the structure [N], load axes.
struct RegionMean {
  std::string region;  ///< as of model::RegionLoads::visit()
  model::RegionLoad load;
};

/// The structure's work and where it is at the end of a run [J]; signs and terms as in model::LoadRow.
struct EnergyBalance {
  double work = 0.0;
  double birth_energy = 0.0;
  double kinetic_energy = 0.0;
  double potential_energy = 0.0;
  double removed_energy = 0.0;
  model::EnergyLosses losses;
  double error = 0.0;
  double largest_step_error = 0.0;  ///< of all steps, in magnitude
};

/// A field of floes at the start.
struct InitialFloes {
  int n = 0;
  double concentration = 0.0;          ///< area of the floes over the field without land [-]
  std::vector<double> size_quantiles;  ///< of the square roots of their areas, 5, 25, 50, 75, 95 % [m]
};

/// The part of a run that its statistics cover, and why.
struct StatisticsWindow {
  double from = 0.0;     ///< loads after this time count [s]; after the run's end: no statistics
  double until = 0.0;    ///< and up to this time, the end of a step [s]
  std::string begins{};  ///< why it begins there, in words that follow "when"
  std::string ends{};    ///< why it ends there
};

/// The loads of a run, as far as the warnings about its result need them.
class LoadsSeen {
 public:
  explicit LoadsSeen(const StatisticsWindow& window) : from_(window.from), until_(window.until) {}

  /// Adds the loads of the next step.
  void add(const model::LoadRow& row);

  std::size_t n_steps() const { return n_steps_; }
  /// When the ice last loaded the structure [s].
  std::optional<double> last_load() const { return last_load_; }
  /// Share of the hull's bottom that floes cover, mean over each half of the window [-]; NaN: no row is in it.
  std::array<double, 2> covered() const { return {sums_[0] / rows_[0], sums_[1] / rows_[1]}; }

 private:
  double from_, until_;
  std::size_t n_steps_ = 0;
  std::optional<double> last_load_{};
  std::array<double, 2> sums_{}, rows_{};
};

/// The summary of a run. Everything here but the program follows from the case and its seed.
struct RunSummary {
  model::Origin origin;            ///< preset and program; empty until the summary is recorded
  StatisticsWindow window;         ///< of the loads and the breaking frequency
  statistics::Summary horizontal;  ///< resistance Fx [N]
  statistics::Summary vertical;    ///< Fz, upwards on the structure [N]
  LoadSplit horizontal_split;
  LoadSplit vertical_split;
  std::vector<RegionMean> regions;     ///< of a hull with regions, empty where no region carried a load
  double mean_horizontal_whole = 0.0;  ///< over the whole history [N]
  double mean_vertical_whole = 0.0;
  double maximum_horizontal_whole = 0.0;
  double maximum_vertical_whole = 0.0;
  double minimum_horizontal_whole = 0.0;
  double minimum_vertical_whole = 0.0;
  int n_breaks = 0;
  BreakCounts breaks;
  model::SheetSolves sheets;
  model::KeptCounts verdicts;
  double breaking_frequency = 0.0;  ///< breaks per second in the window [Hz]
  int n_floes_born = 0;
  int n_floes_present = 0;
  int n_floes_crushed = 0;
  int n_floes_broken = 0;                         ///< again, into floes of their own
  std::vector<double> piece_area_quantiles;       ///< 5, 25, 50, 75, 95 % [m2]
  std::vector<double> breaking_length_quantiles;  ///< 5, 25, 50, 75, 95 % [m]
  /// The same quantiles of CrackEvent::overload, and of the largest stress over the strength, where the structure broke
  /// the ice and the overload is known [-].
  std::vector<double> overload_quantiles, stress_quantiles;
  int n_substepped = 0;  ///< steps that were cut into parts
  int n_below_range = 0;
  int n_above_range = 0;
  int n_steps_too_long = 0;
  double sum_of_last_changes = 0.0;    ///< StepReport::last_change over all steps [m/s]
  double mean_last_change = 0.0;       ///< [m/s]
  double largest_last_change = 0.0;    ///< the largest of all steps [m/s]
  int n_unsettled_steps = 0;           ///< steps whose last change exceeds settled_residual()
  std::optional<double> fastest_floe;  ///< largest speed of any floe between two frames [m/s]; absent without frames
  std::optional<InitialFloes> initial_floes;  ///< absent: the ice is level
  geometry::Ledger ledger;
  EnergyBalance energy;
  std::vector<model::Warning> warnings;  ///< that a checkpoint brought; advice::run adds its own
};

struct Setup;

/// A finished run: results as written, their summary, and where the wall time went.
struct Run {
  model::RunResults results;           ///< without the loads, frames and cracked sheets of `earlier`
  std::vector<std::string> earlier{};  ///< files with these, as of CheckpointStore::earlier, oldest first
  RunSummary summary;
  std::shared_ptr<const Setup> setup{};      ///< of a run that began
  LoadsSeen loads_seen{StatisticsWindow{}};  ///< of a complete run: all steps, those of `earlier` too
  StageTimes stage_times;
  double wall_seconds = 0.0;
  int threads = 1;            ///< that worked at it
  double resumed_from = 0.0;  ///< simulated time that an earlier run had reached [s]; the times above are without it
  std::string started_at;     ///< ISO 8601, UTC
  bool complete = false;      ///< false: interrupted; there are results so far, if it began, and no summary
};

/// Where a run keeps its newest state, and takes it up again. Without functions it keeps nothing and starts at 0 s.
struct CheckpointStore {
  std::string name{};                                          ///< in messages: a file
  std::function<void(const model::Checkpoint&)> keep{};        ///< replaces the state kept before
  std::function<std::optional<model::Checkpoint>()> newest{};  ///< to continue from; nothing: start at 0 s
  /// Writes loads, frames and cracked sheets to a file, beside the state: the results of a long run would fill the
  /// memory. Without it they stay in memory.
  std::function<void(const model::RunResults&)> keep_earlier{};
  /// These files, oldest first.
  std::function<std::vector<std::string>()> earlier{};
  std::function<model::RunResults(const std::string& file)> read_earlier{};
};

/// Adds a warning to a state. A run that continues from there has the warning too, and so have its own states.
void add_warning(model::Checkpoint& checkpoint, const model::Warning& warning);

/// Options around the loop of a run.
struct RunOptions {
  /// Of the case, where it has been made; a run without one makes it before its first step.
  std::shared_ptr<const Setup> setup{};
  /// Called once, when the state that the run begins with is there and before its first step.
  std::function<void()> begun{};
  /// Called after every step.
  std::function<void(const Simulation&, const StepReport&)> observer{};
  /// Takes a checkpoint every `output.checkpoint_interval`.
  CheckpointStore checkpoint{};
  /// Asked after every step and inside long ones; when true the run keeps a checkpoint and stops.
  std::function<bool()> interrupted{};
  /// Threads that share out the loops over floes and contacts, >= 1. Results do not depend on their number.
  int threads = 1;
  /// Loads, frames and cracked sheets that are in memory before they go to a file, where there is a store for them.
  std::size_t most_bytes_in_memory = std::size_t{32} << 20;
};

/// Runs `resolved` to its end, or to where it is interrupted.
/// @throws InputError when the checkpoint is of another case.
/// @throws RunError when a step fails or is not physical (docs/theory/simulation.md): the step, the reason, and
///         where the state before it is kept.
/// @throws whatever `checkpoint` throws, and std::bad_alloc when there is not enough memory. The last
///         checkpoint then remains.
Run run(const model::Case& resolved, const RunOptions& options = {});

/// The summary as JSON, SI units.
std::string to_json(const RunSummary& summary);

/// The window of a run's statistics. It begins as `output.statistics_from` says, or when the structure's last_axis(),
/// of a ship its stern if it passes in the run, has passed the last floe of the initial crack, which the program cut.
/// The preset `paper`, and ice without that crack, begin at the initial edge. The window ends when the foremost
/// point of a structure that goes where the case says leaves fixed level ice.
/// @param initial_crack_radius  of DerivedScales [m].
StatisticsWindow statistics_window(const model::Case& resolved, double initial_crack_radius);

}  // namespace brash::simulation
