// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "brash/core/contract.hpp"
#include "schema.hpp"

namespace brash::io {
namespace {

using Json = nlohmann::json;

bool is_a(const std::string& type, const Json& value) {
  if (type == "number") return value.is_number();
  if (type == "integer") return value.is_number_integer();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "array") return value.is_array();
  BRASH_EXPECTS(type == "object", "a type of JSON");
  return value.is_object();
}

bool is_one_of(const OrderedJson& types, const Json& value) {
  if (types.is_string()) return is_a(types.get<std::string>(), value);
  return std::any_of(types.begin(), types.end(), [&](const auto& type) { return is_a(type, value); });
}

bool is_choice(const OrderedJson& choices, const Json& value) {
  return value.is_string() && std::find(choices.begin(), choices.end(), value.get<std::string>()) != choices.end();
}

/// Characters of UTF-8, each of which has one byte that continues no other.
std::size_t n_characters(const std::string& text) {
  constexpr unsigned kHighBits = 0xC0, kContinues = 0x80;
  return std::count_if(text.begin(), text.end(),
                       [](char c) { return (static_cast<unsigned char>(c) & kHighBits) != kContinues; });
}

/// A number's comparison with a limit; values of other types have none to fail.
template <typename Compare>
bool compares(const OrderedJson& limit, const Json& value) {
  return !value.is_number() || Compare()(value.get<double>(), limit.get<double>());
}

template <typename Compare>
bool has_length(const OrderedJson& limit, const Json& value) {
  return !value.is_array() || Compare()(value.size(), limit.get<std::size_t>());
}

bool is_short(const OrderedJson& limit, const Json& value) {
  return !value.is_string() || n_characters(value.get<std::string>()) <= limit.get<std::size_t>();
}

bool allows_items(const OrderedJson& each, const Json& value) {
  return !value.is_array() ||
         std::all_of(value.begin(), value.end(), [&](const Json& item) { return allows(each, item); });
}

/// The keywords that limit values.
const std::map<std::string_view, bool (*)(const OrderedJson& limit, const Json& value)> kChecks = {
    {"type", is_one_of},
    {"enum", is_choice},
    {"minimum", compares<std::greater_equal<>>},
    {"maximum", compares<std::less_equal<>>},
    {"exclusiveMinimum", compares<std::greater<>>},
    {"exclusiveMaximum", compares<std::less<>>},
    {"minItems", has_length<std::greater_equal<>>},
    {"maxItems", has_length<std::less_equal<>>},
    {"maxLength", is_short},
    {"items", allows_items},
};

bool is_annotation(const std::string& keyword) {
  return keyword == "description" || keyword == "default" || keyword == "examples" || keyword.starts_with("x-");
}

}  // namespace

bool allows(const OrderedJson& key_schema, const Json& value) {
  for (const auto& [keyword, limit] : key_schema.items()) {
    if (is_annotation(keyword)) continue;
    const auto check = kChecks.find(keyword);
    BRASH_EXPECTS(check != kChecks.end(), "a keyword of the schema that this check knows");
    if (!check->second(limit, value)) return false;
  }
  return true;
}

}  // namespace brash::io
