// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brash/model/origin.hpp"
#include "brash/model/warning.hpp"

namespace brash::io {

/// Whether a folder is a campaign's, and not a run's: it has the table campaign.csv.
bool is_campaign(const std::string& folder);

/// The number `statistics_from` of a `summary.json` [s], if it has one.
std::optional<double> start_in(const std::string& summary);

/// The number `statistics_until` [s], if it has one.
std::optional<double> end_in(const std::string& summary);

/// The start of the statistics [s] in the `summary.json` beside the history.csv or run.nc of a run; nothing where no
/// summary has one, and beside files with other names.
std::optional<double> start_beside(const std::string& history);
/// The end of the statistics there [s].
std::optional<double> end_beside(const std::string& history);

/// The warnings in the same `summary.json`; none where there is no such summary.
std::vector<model::Warning> warnings_beside(const std::string& history);

/// The origin of the run that a history is of: of a netCDF file as it says itself, of a history.csv as the
/// manifest.json beside it says. Empty for a measurement.
model::Origin origin_of_history(const std::string& history);

}  // namespace brash::io
