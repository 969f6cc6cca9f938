// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace brash::analysis {

/// A question to a campaign's table.
struct TrendSettings {
  std::string along;                               ///< key of the grid, such as structure.angle
  std::vector<std::string> of{"horizontal.mean"};  ///< columns; their p-values are adjusted for their number
  std::string where;                               ///< only settings whose name matches, such as "angle-50deg_*"
};

/// Tests whether results rise or fall along one key of a campaign's grid: the test of Jonckheere and Terpstra within
/// each combination of the other keys, Kendall's tau, and the last setting less the first with its interval. Holm's
/// method adjusts the p-values of all columns, and their intervals together hold with 95 %.
///
/// @param table_file  campaign.csv; the summary.json beside it names the varied keys.
/// @return `along`, `where`, `trends` with one entry a column, `warnings` with the number of cases that have each.
/// @throws InputError naming the table and the part that it lacks: a column, two settings, two replicates of each.
/// @see Jonckheere, Biometrika 41, 1954; Terpstra, Indagationes Mathematicae 14, 1952.
nlohmann::ordered_json trends_of(const std::string& table_file, const TrendSettings& asked);

/// The same as text for a reader.
std::string trend_text(const nlohmann::ordered_json& trends);

}  // namespace brash::analysis
