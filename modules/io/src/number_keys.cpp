// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <type_traits>

#include "brash/io/case.hpp"
#include "brash/model/case_keys.hpp"
#include "schema.hpp"

namespace brash::io {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

double least_of(const OrderedJson& key) {
  if (key.contains("exclusiveMinimum")) return std::nextafter(key.at("exclusiveMinimum").get<double>(), kFar);
  return key.value("minimum", std::numeric_limits<double>::lowest());
}

double most_of(const OrderedJson& key) {
  if (key.contains("exclusiveMaximum")) return std::nextafter(key.at("exclusiveMaximum").get<double>(), -kFar);
  return key.value("maximum", std::numeric_limits<double>::max());
}

}  // namespace

std::vector<NumberKey> number_keys(const model::Case& resolved) {
  std::vector<NumberKey> keys;
  model::visit_keys(resolved, [&](const char* section, const char* key, const auto& value) {
    using Value = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, std::uint64_t>) {
      const OrderedJson& schema = schema_of_cases().keys(section).at(key);
      keys.push_back({section, key, schema.value("x-unit", "1"), schema.at("description").get<std::string>(),
                      least_of(schema), most_of(schema)});
    }
  });
  return keys;
}

}  // namespace brash::io
