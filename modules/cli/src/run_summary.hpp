// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brash/model/warning.hpp"

namespace brash::cli {

/// The number `statistics_from` of a `summary.json` [s], if it has one.
std::optional<double> start_in(const std::string& summary);

/// The start of the statistics [s] in the `summary.json` beside the history.csv or run.nc of a run; nothing where no
/// summary has one, and beside files with other names.
std::optional<double> start_beside(const std::string& history);

/// The warnings in the same `summary.json`; none where there is no such summary.
std::vector<model::Warning> warnings_beside(const std::string& history);

}  // namespace brash::cli
