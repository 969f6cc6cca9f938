// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "load_history.hpp"

namespace brash::cli {

/// Adds to a comparison how the cases of both sides differ, if a manifest beside the first history of each side names
/// its case: `inputs_that_differ`, a key with both values each, and `same_run`, the file that both sides have, or
/// that both would have because one program ran one case. Sides with several replicates may differ in the replicate.
void add_case_differences(const std::vector<LoadHistory>& runs, const std::vector<LoadHistory>& measured,
                          nlohmann::ordered_json& comparison);

/// The same as text for a reader; "" where neither is known.
std::string case_differences_text(const nlohmann::ordered_json& comparison);

}  // namespace brash::cli
