// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "brash/statistics/extreme_analysis.hpp"

namespace brash::cli {

/// Adds the extremes to the statistics of a history or of pooled ones: `extremes` (Pareto), `block_maxima` (Gumbel),
/// `laws` (all five, with levels, intervals and tests), `recommended` with its reason, `warnings`.
void add_extremes(const statistics::ExtremeAnalysis& analysis, nlohmann::ordered_json& out);

/// "[1, 2]" for the ends of an interval; "[1, no upper end]".
std::string ends_text(const nlohmann::ordered_json& ends);

/// The extremes as text for a reader.
std::string extremes_text(const nlohmann::ordered_json& statistics);

}  // namespace brash::cli
