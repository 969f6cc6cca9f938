// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace brash::io {

using OrderedJson = nlohmann::ordered_json;

/// The first line of a new case, by which editors find the schema beside it.
inline constexpr const char* kSchemaLine = "#:schema case.schema.json\n";

/// The allowed content of a strict TOML file: sections of keys. A section within a section is one more,
/// "structure.motion".
class Schema {
 public:
  /// @param kind  the name of such a file, "case" or "plan".
  /// @param text  a JSON Schema.
  Schema(std::string kind, const char* text);

  const std::string& kind() const { return kind_; }
  const OrderedJson& tree() const { return tree_; }
  /// The sections in the order of the schema.
  const OrderedJson& sections() const { return tree_.at("properties"); }
  /// The schemas of the keys of `section`, in the order of the schema.
  const OrderedJson& keys(const std::string& section) const { return sections().at(section).at("properties"); }
  /// A part without listed keys: who reads the file checks it.
  static bool is_free(const OrderedJson& part);
  /// The preset of a document, by its name: the stated one, else the default; empty where the schema has none.
  std::string preset_of(const nlohmann::json& document) const;
  /// The schema of a key in a section whose key `kind` has this value: some kinds take fewer names than others, and
  /// the first name by default where the default is another's.
  static OrderedJson of_kind(const OrderedJson& key_schema, const std::string& kind);
  /// The line that takes the place of a key with this name in earlier versions; "" without one.
  std::string successor(const std::string& section, const std::string& key) const;
  /// The value that a key with this name of earlier versions has in all cases now; "" without one.
  std::string fixed_value(const std::string& section, const std::string& key) const;
  /// Whether a key has a default under a preset.
  static bool has_default(const OrderedJson& key_schema, const std::string& preset);
  /// The default of a key under a preset, one that it has.
  static const OrderedJson& default_in(const OrderedJson& key_schema, const std::string& preset);
  bool requires_section(const std::string& section) const;
  /// Whether a section whose key `kind` has this value lacks something without the key.
  bool requires_key(const std::string& section, const std::string& key, const std::string& kind) const;
  /// The keys that take the place of a key, section and name.
  std::vector<std::string> in_place_of(const std::string& section, const std::string& key) const;
  /// Whether a section within another one belongs to the one around it, where the key `kind` of that has this value.
  bool has_section(const std::string& section, const std::string& kind_around) const;
  /// Whether the key belongs to a section whose key `kind` has this value.
  bool has_key(const std::string& section, const std::string& key, const std::string& kind) const;

 private:
  std::string kind_;
  OrderedJson tree_;
};

/// The schema of case files, case.schema.json.
const Schema& schema_of_cases();
/// The schema of the plans of campaigns, plan.schema.json.
const Schema& schema_of_plans();

/// The JSON type of the values of `key_schema` that are not strings with a unit: "number", "integer", "array", ...
std::string value_type(const OrderedJson& key_schema);
/// The allowed values, in words and SI: "a number > 0 and <= 10 in m, or a quantity such as \"0.33 m\"".
std::string allowed_values(const OrderedJson& key_schema);
/// The plausible values in a sentence: "Plausible: 5 cm to 5 m at sea, 0.5 cm to 25 cm in model ice."; "" without any.
std::string plausible_values(const OrderedJson& key_schema);
/// Their sources in a sentence; "" without any.
std::string plausible_sources(const OrderedJson& key_schema);
/// `key_schema`'s default as TOML.
std::string toml_text(const OrderedJson& value);
/// `value` as a TOML number that reads back to the same double.
std::string toml_number(double value);
/// `text` as a TOML basic string.
std::string toml_string(const std::string& text);
/// `text` as comment lines of TOML, at most 100 columns wide.
std::string commented(const std::string& text);

/// Whether the schema of a key allows a value: its type, choices, range, lengths and items. Numbers with a fraction of
/// zero are no integers. Every other keyword must be an annotation, which says nothing about values.
/// @param value  in SI.
bool allows(const OrderedJson& key_schema, const nlohmann::json& value);

/// The texts of case.schema.json, plan.schema.json and site_ice.json.
extern const char* const kCaseSchemaText;
extern const char* const kPlanSchemaText;
extern const char* const kSiteIceText;

}  // namespace brash::io
