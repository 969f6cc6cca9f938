// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "brash/analysis/history_growth.hpp"
#include "brash/analysis/load_history.hpp"
#include "brash/statistics/summary.hpp"

namespace brash::analysis {

/// A run's history against a measured one: mean, deviation, peaks, growth, distribution and spectrum, each with a 95 %
/// interval or a test. `differs` names the statistics that differ at 5 %, all tests adjusted together by Holm's method.
/// `could_hide` has the largest relative difference that each interval still holds.
///
/// @param speeds  of the ice on both sides; with them the growth is compared over equal travel.
nlohmann::ordered_json compare_histories(const LoadHistory& run, const LoadHistory& measured,
                                         const IceSpeeds& speeds = {});

/// The same of several histories a side, such as the replicates of a campaign. The histories of a side are independent,
/// so their spread gives the errors, not the correlation within one history.
nlohmann::ordered_json compare_histories(const std::vector<LoadHistory>& runs, const std::vector<LoadHistory>& measured,
                                         const IceSpeeds& speeds = {});

/// A number of each history, as the summary of independent values.
statistics::Summary over_replicates(const std::vector<double>& values);

/// Histories one after another with gaps between them.
/// @throws InputError when their units differ.
LoadHistory joined(const std::vector<LoadHistory>& loads);

/// What the two sides of a comparison are: a run, whose origin is known, or a measurement. "run" and "measured", or
/// "run 1" and "run 2" where both are of one kind.
std::array<std::string, 2> side_names(const nlohmann::ordered_json& comparison);

/// The same as text for a reader.
std::string comparison_text(const nlohmann::ordered_json& comparison);

/// Adds to a comparison how the cases of both sides differ, if a manifest beside the first history of each side names
/// its case: `inputs_that_differ`, a key with both values each, and `same_run`, the file that both sides have, or
/// that both would have because one program ran one case. Sides with several replicates may differ in the replicate.
void add_case_differences(const std::vector<LoadHistory>& runs, const std::vector<LoadHistory>& measured,
                          nlohmann::ordered_json& comparison);

/// The same as text for a reader; "" where neither is known.
std::string case_differences_text(const nlohmann::ordered_json& comparison);

}  // namespace brash::analysis
