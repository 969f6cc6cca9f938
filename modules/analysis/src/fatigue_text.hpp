// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "brash/analysis/tables.hpp"

namespace brash::analysis {

/// fatigue_text() with its loads in `unit`, whose name stands beside them.
std::string fatigue_text(const nlohmann::ordered_json& fatigue, const TableUnit& unit);

}  // namespace brash::analysis
