// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace brash::io {

using OrderedJson = nlohmann::ordered_json;

/// The text of case.schema.json.
extern const char* const kCaseSchemaText;

/// The schema, its keys in the order of the file.
const OrderedJson& schema();
/// The sections in the order of the file.
const OrderedJson& section_schemas();
/// The schemas of the keys of `section`, in the order of the file.
const OrderedJson& key_schemas(const std::string& section);
bool is_required(const std::string& section, const std::string& key);

/// The JSON type of the values of `key_schema` that are not strings with a unit: "number", "integer", "array", ...
std::string value_type(const OrderedJson& key_schema);
/// What may be written, in words and SI: "a number > 0 and <= 10 in m, or a quantity such as \"0.33 m\"".
std::string allowed_values(const OrderedJson& key_schema);
/// `key_schema`'s default as TOML.
std::string toml_text(const OrderedJson& value);
/// `value` as a TOML number that reads back to the same double.
std::string toml_number(double value);
/// `text` as a TOML basic string.
std::string toml_string(const std::string& text);

}  // namespace brash::io
