// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "brash/core/vec.hpp"
#include "brash/model/records.hpp"
#include "brash/model/warning.hpp"
#include "brash/simulation/run.hpp"

namespace brash::simulation {

/// A mean of fewer independent samples than this gets no interval: its estimate of the deviation is itself a guess.
inline constexpr double kFewSamples = 10.0;

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

/// Warnings about a result: no load or no break at all, too few independent samples of the load, a mean of another
/// order of magnitude than the reference, or contacts that are not settled. derived_scales() has the warnings about the
/// case. RunSummary::warnings has both. docs/reference/warnings.md
/// @param loads  of all steps of the run.
std::vector<model::Warning> warnings_of(const RunSummary& summary, const LoadsSeen& loads,
                                        const model::ReferenceSection& reference);

/// Residual of a step above which its contacts are not settled [m/s]: the larger of two. At 8e-5 m/s a floe sinks into
/// its neighbour by 5 mm a minute. At 3 % of the speed of structure and water against each other, a contact shifts by 3
/// % of the distance that the ice moves, and mean loads may be some 5 % too low.
double settled_residual(Vec2 structure, Vec2 current);

/// Whether the loads of a run with these warnings get intervals: the run is long enough, and ice loaded the structure
/// and broke.
bool bear_interval(std::span<const model::Warning> warnings);

/// Whether a mean of `summary` gets an interval: enough independent samples, of a run that is long enough and in which
/// ice loaded the structure and broke.
bool bears_interval(const RunSummary& summary, const statistics::Summary& load);

}  // namespace brash::simulation
