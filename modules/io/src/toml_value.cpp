// SPDX-License-Identifier: GPL-3.0-or-later
#include "toml_value.hpp"

#include <cmath>
#include <utility>

#include "quantity.hpp"

namespace brash::io {
namespace {

using Json = nlohmann::json;

tl::expected<Json, ValueError> array_to_json(const toml::array& array, const OrderedJson& key_schema) {
  static const OrderedJson kNone = {{"type", "null"}};
  const OrderedJson& item_schema = key_schema.contains("items") ? key_schema.at("items") : kNone;
  Json items = Json::array();
  for (const toml::node& item : array) {
    OrderedJson of_column = item_schema;
    if (key_schema.contains("x-units") && items.size() < key_schema.at("x-units").size())
      of_column["x-unit"] = key_schema.at("x-units").at(items.size());
    tl::expected<Json, ValueError> converted = json_value(item, of_column);
    if (!converted) return converted;
    items.push_back(std::move(*converted));
  }
  return items;
}

}  // namespace

tl::expected<nlohmann::json, ValueError> json_value(const toml::node& node, const OrderedJson& key_schema) {
  if (const auto* value = node.as_boolean()) return Json(value->get());
  if (const auto* value = node.as_integer()) return Json(value->get());
  if (const auto* value = node.as_floating_point()) {
    if (!std::isfinite(value->get())) return tl::unexpected(ValueError{"is not finite", "write a finite number"});
    return Json(value->get());
  }
  if (const auto* value = node.as_string()) {
    if (value_type(key_schema) != "number") return Json(value->get());
    auto number = read_quantity(value->get(), key_schema.at("x-unit").get<std::string>());
    if (!number) return tl::unexpected(ValueError{std::move(number.error().what), std::move(number.error().remedy)});
    return Json(*number);
  }
  if (const auto* value = node.as_array()) return array_to_json(*value, key_schema);
  if (node.is_table())
    return tl::unexpected(
        ValueError{"is a table, not a value", "write one value; below a section are keys, nothing deeper"});
  return tl::unexpected(ValueError{"is a date or time, not a value", "write a number, or a string in quotes"});
}

}  // namespace brash::io
