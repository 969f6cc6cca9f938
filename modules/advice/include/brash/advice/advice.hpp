// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/model/warning.hpp"
#include "brash/simulation/run.hpp"
#include "brash/simulation/setup.hpp"

namespace brash::advice {

/// Warnings about a case. docs/reference/warnings.md
std::vector<model::Warning> warnings_of(const simulation::Setup& setup);
/// The same of a case that is resolved for this alone.
std::vector<model::Warning> warnings_of(const model::Case& resolved);

/// Warnings about a result: no load or no break at all, too few independent samples of the load, a mean of another
/// order of magnitude than the reference, or contacts that are not settled. docs/reference/warnings.md
/// @param loads  of all steps of the run.
std::vector<model::Warning> warnings_of(const simulation::RunSummary& summary, const simulation::LoadsSeen& loads,
                                        const model::ReferenceSection& reference);

/// simulation::run(), and the summary of a run that is whole has the warnings about its case and its result.
simulation::Run run(const model::Case& resolved, const simulation::RunOptions& options = {});

}  // namespace brash::advice
