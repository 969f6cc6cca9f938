// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "brash/core/vec.hpp"
#include "brash/model/records.hpp"
#include "brash/model/warning.hpp"
#include "brash/simulation/run.hpp"

namespace brash::simulation {

/// A mean of fewer independent samples than this gets no interval: its estimate of the deviation is itself a guess.
inline constexpr double kFewSamples = 10.0;

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
