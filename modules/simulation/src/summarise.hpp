// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/simulation/run.hpp"

namespace brash::simulation {

/// Completes `counts` (the counters and the ledger of the run) with the statistics of its results.
/// @param open_water  area of the field without its land [m2].
RunSummary summarise(const model::Case& resolved, const model::RunResults& results, double open_water,
                     RunSummary counts);

}  // namespace brash::simulation
