// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "brash/model/origin.hpp"

namespace brash::cli {

/// Adds the preset and the program behind a table to its JSON, under `origin`; nothing for a measurement.
void add_origin(const model::Origin& origin, nlohmann::ordered_json& table);

/// The same as a line of the table's text, after `before`; "" without an origin.
std::string origin_text(const nlohmann::ordered_json& table, const std::string& before = "");

}  // namespace brash::cli
