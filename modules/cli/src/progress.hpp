// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "brash/model/case.hpp"
#include "brash/simulation/run.hpp"

namespace brash::cli {

/// Runs a case as `options` say, with a line of progress on a terminal. Ctrl-C, a terminal that closes, or a request to
/// end stops it after its step and, where there is a store, keeps a checkpoint; the run is then not complete.
simulation::Run run_with_progress(const model::Case& resolved, simulation::RunOptions options);

}  // namespace brash::cli
