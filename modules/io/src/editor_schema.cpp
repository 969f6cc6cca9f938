// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "brash/io/case.hpp"
#include "schema.hpp"

namespace brash::io {
namespace {

/// Adds what keywords of the program's own state to the description that an editor shows.
void describe(OrderedJson& schema) {
  std::string text = schema.value("description", "");
  const auto add = [&](const std::string& more) { text += (text.empty() ? "" : " ") + more; };
  const auto list = [&](const char* keyword) {
    return fmt::format("{}", fmt::join(schema.at(keyword).get<std::vector<std::string>>(), ", "));
  };
  if (const std::string plausible = plausible_values(schema); !plausible.empty()) add(plausible);
  if (schema.contains("x-units")) add(fmt::format("Units: {}.", list("x-units")));
  if (const std::string unit = schema.value("x-unit", "1"); unit != "1") add(fmt::format("Unit: {}.", unit));
  if (schema.contains("x-kinds")) add(fmt::format("Only with kind = {}.", list("x-kinds")));
  if (!text.empty()) schema["description"] = text;
}

std::vector<std::string> limits_of(const std::string& type) {
  if (type == "number") return {"minimum", "maximum", "exclusiveMinimum", "exclusiveMaximum"};
  if (type == "array") return {"items", "minItems", "maxItems"};
  return {"maxLength"};
}

/// Replaces a list of types by one schema for each, with the limits of its type.
void split_types(OrderedJson& schema) {
  if (!schema.contains("type") || !schema.at("type").is_array()) return;
  OrderedJson each = OrderedJson::array();
  for (const std::string type : schema.at("type")) {
    OrderedJson one{{"type", type}};
    for (const std::string& limit : limits_of(type)) {
      if (!schema.contains(limit)) continue;
      one[limit] = schema.at(limit);
      schema.erase(limit);
    }
    each.push_back(std::move(one));
  }
  schema.erase("type");
  schema["anyOf"] = std::move(each);
}

OrderedJson for_editors(OrderedJson schema) {
  if (schema.contains("properties"))
    for (auto& [key, of_key] : schema.at("properties").items()) of_key = for_editors(of_key);
  if (schema.contains("items")) schema["items"] = for_editors(schema.at("items"));
  describe(schema);
  std::vector<std::string> own;
  for (const auto& [keyword, value] : schema.items())
    if (keyword.starts_with("x-") || keyword == "$comment") own.push_back(keyword);
  for (const std::string& keyword : own) schema.erase(keyword);
  split_types(schema);
  return schema;
}

}  // namespace

std::string editor_schema(const std::string& schema) { return for_editors(OrderedJson::parse(schema)).dump(2) + "\n"; }

}  // namespace brash::io
