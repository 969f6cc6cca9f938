// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/simulation/run.hpp"

namespace brash::simulation {

/// Completes `counts` (the counters and the ledger of the run) with the statistics of its results.
RunSummary summarise(const model::Case& resolved, const model::RunResults& results, RunSummary counts);

}  // namespace brash::simulation
