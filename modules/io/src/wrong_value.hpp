// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "problem.hpp"
#include "schema.hpp"
#include "toml_source.hpp"

namespace brash::io {

/// Says what is wrong with a value that `key_schema` refuses.
/// @param value  in SI.
Problem wrong_value(const CaseSource& source, const std::string& section, const std::string& key,
                    const OrderedJson& key_schema, const nlohmann::json& value);

}  // namespace brash::io
