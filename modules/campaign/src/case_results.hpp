// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "brash/model/case.hpp"
#include "brash/model/warning.hpp"
#include "brash/statistics/summary.hpp"

namespace brash::campaign {

/// The numbers of a run's summary (JSON text) by their columns' names.
/// @throws InputError naming `path` when the text is not JSON.
std::map<std::string, double> columns_of(const std::string& path, const std::string& summary);

/// The same text for runs with the same numbers to the last digit, and another one for any others.
std::string fingerprint(const std::map<std::string, double>& numbers);

/// The unit of a known column (UDUNITS); 1 for counts, ratios, and yes or no.
std::string unit_of(const std::string& column);

/// The least and the largest value that a known column can have: a count is not negative, a share is not above 1.
statistics::Interval possible_values(const std::string& column);

/// The warnings in a run's summary.
std::vector<model::Warning> warnings_in(const std::string& summary);

/// Why a done case is not as its campaign made it; empty: it is. Its manifest has to name this case and replicate, and
/// the results have to have the hashes of the manifest.
/// @param expected  the case as results record it.
std::string why_unfit(const std::filesystem::path& case_folder, const model::Case& expected);

}  // namespace brash::campaign
