// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "brash/model/case.hpp"
#include "brash/simulation/run.hpp"

namespace brash::cli {

/// The summary of a run as a table for people, the closed forms' peaks beside it.
std::string run_table(const model::Case& resolved, const simulation::Run& run);

}  // namespace brash::cli
