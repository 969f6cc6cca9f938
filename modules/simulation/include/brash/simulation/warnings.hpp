// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/model/warning.hpp"
#include "brash/simulation/run.hpp"

namespace brash::simulation {

/// A mean of fewer independent samples than this gets no interval: its estimate of the deviation is itself a guess.
inline constexpr double kFewSamples = 10.0;

/// Warnings about a result: no break at all, or too few independent samples of the load. derived_scales() has the
/// warnings about the case. RunSummary::warnings has both. docs/reference/warnings.md
std::vector<model::Warning> warnings_of(const RunSummary& summary);

}  // namespace brash::simulation
