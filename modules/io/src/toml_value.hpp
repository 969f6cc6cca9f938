// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <toml++/toml.h>

#include <nlohmann/json.hpp>
#include <string>
#include <tl/expected.hpp>

#include "problem.hpp"
#include "schema.hpp"
#include "toml_source.hpp"

namespace brash::io {

/// Why a TOML value is not a value of a case, and the remedy.
struct ValueError {
  std::string what;
  std::string remedy;
};

/// A TOML value as JSON, quantities in the unit of `key_schema`.
tl::expected<nlohmann::json, ValueError> json_value(const toml::node& node, const OrderedJson& key_schema);

/// The fault of a value that `key_schema` refuses.
/// @param value  in SI.
Problem wrong_value(const CaseSource& source, const std::string& section, const std::string& key,
                    const OrderedJson& key_schema, const nlohmann::json& value);

}  // namespace brash::io
