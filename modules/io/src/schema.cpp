// SPDX-License-Identifier: GPL-3.0-or-later
#include "schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "brash/core/quantity_text.hpp"
#include "brash/core/text.hpp"
#include "brash/io/campaign_plan.hpp"
#include "brash/io/case.hpp"

namespace brash::io {

namespace {

/// Whether the list `word` of a schema, if it has one, holds `name`.
bool holds(const OrderedJson& schema, const char* word, const std::string& name) {
  if (!schema.contains(word)) return false;
  const OrderedJson& names = schema.at(word);
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool lists(const OrderedJson& schema, const std::string& name) { return holds(schema, "required", name); }

}  // namespace

Schema::Schema(std::string kind, const char* text) : kind_(std::move(kind)), tree_(OrderedJson::parse(text)) {
  OrderedJson sections = OrderedJson::object();
  for (auto& [name, section] : tree_.at("properties").items()) {
    OrderedJson subsections = OrderedJson::object(), keys = OrderedJson::object();
    if (section.contains("properties")) {
      for (auto& [key, key_schema] : section.at("properties").items()) {
        const bool is_subsection = key_schema.contains("properties");
        (is_subsection ? subsections[name + "." + key] : keys[key]) = key_schema;
      }
      section.at("properties") = std::move(keys);
    }
    sections[name] = section;
    sections.update(subsections);
  }
  tree_.at("properties") = std::move(sections);
}

bool Schema::has_section(const std::string& section, const std::string& kind_around) const {
  const OrderedJson& part = sections().at(section);
  return !part.contains("x-kinds") || holds(part, "x-kinds", kind_around);
}

bool Schema::has_key(const std::string& section, const std::string& key, const std::string& kind) const {
  const OrderedJson& key_schema = keys(section).at(key);
  return !key_schema.contains("x-kinds") || holds(key_schema, "x-kinds", kind);
}

bool Schema::is_free(const OrderedJson& part) {
  const std::string type = value_type(part);
  return (type == "object" && !part.contains("properties")) ||
         (type == "array" && value_type(part.at("items")) == "object");
}

std::string Schema::preset_of(const nlohmann::json& document) const {
  if (!sections().contains("algorithm")) return "";
  const OrderedJson& key = keys("algorithm").at("preset");
  return document.value("algorithm", nlohmann::json::object()).value("preset", key.at("default").get<std::string>());
}

namespace {

bool is_set_by(const OrderedJson& key_schema, const std::string& preset) {
  return key_schema.contains("x-presets") && key_schema.at("x-presets").contains(preset);
}

}  // namespace

bool Schema::has_default(const OrderedJson& key_schema, const std::string& preset) {
  return key_schema.contains("default") || is_set_by(key_schema, preset);
}

const OrderedJson& Schema::default_in(const OrderedJson& key_schema, const std::string& preset) {
  return is_set_by(key_schema, preset) ? key_schema.at("x-presets").at(preset) : key_schema.at("default");
}

OrderedJson Schema::of_kind(const OrderedJson& key_schema, const std::string& kind) {
  OrderedJson narrowed = key_schema;
  if (!key_schema.contains("x-of-kinds") || !key_schema.at("x-of-kinds").contains(kind)) return narrowed;
  const OrderedJson& names = key_schema.at("x-of-kinds").at(kind);
  narrowed["enum"] = names;
  if (std::find(names.begin(), names.end(), narrowed.at("default")) == names.end()) narrowed["default"] = names.front();
  return narrowed;
}

std::string Schema::successor(const std::string& section, const std::string& key) const {
  const OrderedJson& part = sections().at(section);
  return part.contains("x-renamed") ? part.at("x-renamed").value(key, "") : "";
}

std::string Schema::fixed_value(const std::string& section, const std::string& key) const {
  const OrderedJson& part = sections().at(section);
  return part.contains("x-fixed") ? part.at("x-fixed").value(key, "") : "";
}

bool Schema::requires_section(const std::string& section) const { return lists(tree_, section); }

bool Schema::requires_key(const std::string& section, const std::string& key, const std::string& kind) const {
  const OrderedJson& key_schema = keys(section).at(key);
  const bool depends =
      key_schema.contains("x-kinds") || key_schema.contains("x-short-for") || key_schema.contains("x-required");
  const bool is_optional = holds(key_schema, "x-optional-for", kind);
  return lists(sections().at(section), key) || (depends && !key_schema.contains("default") && !is_optional);
}

std::vector<std::string> Schema::in_place_of(const std::string& section, const std::string& key) const {
  std::vector<std::string> others;
  for (const auto& [other_section, part] : sections().items()) {
    if (is_free(part)) continue;
    for (const auto& [other, other_schema] : part.at("properties").items())
      if (holds(other_schema, "x-instead-of", section + "." + key)) others.push_back(other_section + "." + other);
  }
  return others;
}

const Schema& schema_of_cases() {
  static const Schema schema("case", kCaseSchemaText);
  return schema;
}

const Schema& schema_of_plans() {
  static const Schema schema("plan", kPlanSchemaText);
  return schema;
}

std::string value_type(const OrderedJson& key_schema) {
  const OrderedJson& type = key_schema.at("type");
  return type.is_array() ? type.front().get<std::string>() : type.get<std::string>();
}

std::string toml_number(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::string toml_string(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      quoted += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      quoted += c;
    }
  }
  return escaped_as_unicode(quoted) + '"';
}

std::string toml_text(const OrderedJson& value) {
  if (value.is_string()) return toml_string(value.get<std::string>());
  if (value.is_number_float()) return toml_number(value.get<double>());
  if (!value.is_array()) return value.dump();
  std::string items;
  for (const OrderedJson& item : value) items += (items.empty() ? "" : ", ") + toml_text(item);
  return "[" + items + "]";
}

namespace {

/// " > 0 and <= 10", " from 1 to 16", "".
std::string range_text(const OrderedJson& key_schema) {
  std::vector<std::string> bounds;
  const auto add = [&](const char* keyword, const char* sign) {
    if (key_schema.contains(keyword)) bounds.push_back(fmt::format("{} {}", sign, key_schema.at(keyword).dump()));
  };
  add("minimum", ">=");
  add("exclusiveMinimum", ">");
  add("maximum", "<=");
  add("exclusiveMaximum", "<");
  return bounds.empty() ? "" : fmt::format(" {}", fmt::join(bounds, " and "));
}

/// " (5 to 89 degrees)"
std::string degrees_text(const OrderedJson& key_schema) {
  constexpr double kDegrees = 57.29577951308232;
  if (!key_schema.contains("minimum") || !key_schema.contains("maximum")) return "";
  return fmt::format(" ({:.4g} to {:.4g} degrees)", kDegrees * key_schema.at("minimum").get<double>(),
                     kDegrees * key_schema.at("maximum").get<double>());
}

std::string number_text(const OrderedJson& key_schema) {
  const std::string unit = key_schema.at("x-unit").get<std::string>();
  std::string text = "a finite number" + range_text(key_schema);
  if (unit == "1") return text;
  if (unit == "rad") text += degrees_text(key_schema);
  text += " in " + unit + ", or a string with a unit that converts to " + unit;
  if (key_schema.contains("examples")) text += ", such as " + key_schema.at("examples").front().dump();
  return text;
}

/// How many items an array has.
std::string count_text(const OrderedJson& key_schema) {
  const int least = key_schema.at("minItems").get<int>();
  if (!key_schema.contains("maxItems")) return fmt::format("{} or more", least);
  const int most = key_schema.at("maxItems").get<int>();
  return least == most ? std::to_string(least) : fmt::format("{} to {}", least, most);
}

}  // namespace

std::string allowed_values(const OrderedJson& key_schema) {
  const std::string type = value_type(key_schema);
  if (key_schema.contains("enum")) {
    std::vector<std::string> names;
    for (const OrderedJson& name : key_schema.at("enum")) names.push_back(name.dump());
    return (names.size() == 1 ? "" : "one of ") + fmt::format("{}", fmt::join(names, ", "));
  }
  if (type == "number") return number_text(key_schema);
  if (type == "integer") return "a whole number" + range_text(key_schema);
  if (type == "boolean") return "true or false";
  if (key_schema.contains("x-units"))
    return fmt::format("[{}], all{}", fmt::join(key_schema.at("x-units").get<std::vector<std::string>>(), ", "),
                       range_text(key_schema.at("items")));
  if (type == "array" && key_schema.contains("minItems"))
    return fmt::format("an array of {}, each {}", count_text(key_schema), allowed_values(key_schema.at("items")));
  if (type == "array") return "an array, each item " + allowed_values(key_schema.at("items"));
  return "a string";
}

namespace {

/// The columns of plausible values: a word of the schema, and the same for readers.
constexpr std::pair<const char*, const char*> kColumns[] = {{"sea", "at sea"}, {"model", "in model ice"}};

/// What `text` makes of each column that the key has, joined by `between`.
template <typename Text>
std::string of_columns(const OrderedJson& key_schema, const char* between, const Text& text) {
  std::string joined;
  if (!key_schema.contains("x-plausible")) return joined;
  for (const auto& [column, name] : kColumns)
    if (key_schema.at("x-plausible").contains(column))
      joined += (joined.empty() ? "" : between) + text(key_schema.at("x-plausible").at(column), name);
  return joined;
}

}  // namespace

std::string plausible_values(const OrderedJson& key_schema) {
  const std::string unit = key_schema.value("x-unit", "1");
  const std::string values = of_columns(key_schema, ", ", [&](const OrderedJson& range, const char* name) {
    return fmt::format("{} to {} {}", quantity_text(range.at("least").get<double>(), unit),
                       quantity_text(range.at("most").get<double>(), unit), name);
  });
  return values.empty() ? "" : "Plausible: " + values + ".";
}

std::string plausible_sources(const OrderedJson& key_schema) {
  return of_columns(key_schema, " ", [](const OrderedJson& range, const char* name) {
    std::string source = fmt::format("{}: {}.", name, range.at("source").get<std::string>());
    source.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(source.front())));
    return source;
  });
}

std::string case_schema() { return kCaseSchemaText; }
std::string plan_schema() { return kPlanSchemaText; }

}  // namespace brash::io
