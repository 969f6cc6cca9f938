// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brash/model/case.hpp"
#include "brash/model/warning.hpp"
#include "brash/simulation/run.hpp"

namespace brash::cli {

/// Prints each warning to stderr, as `warning: id: text`.
void print_warnings(const std::vector<model::Warning>& warnings);

/// The summary of a run as a table for people, the closed forms' peaks beside it.
std::string run_table(const model::Case& resolved, const simulation::Run& run);

}  // namespace brash::cli
