// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "brash/core/text.hpp"
#include "quantity.hpp"
#include "toml_value.hpp"

namespace brash::io {
namespace {

/// A bare number was meant in another unit, when it lies within the range in that unit.
std::string remedy_of_range(const OrderedJson& key_schema, const nlohmann::json& value, bool is_bare) {
  const std::string unit = key_schema.at("x-unit").get<std::string>();
  const double least = key_schema.value("minimum", key_schema.value("exclusiveMinimum", -HUGE_VAL));
  const double most = key_schema.value("maximum", key_schema.value("exclusiveMaximum", HUGE_VAL));
  for (const std::string& meant : is_bare ? usual_units(unit) : std::vector<std::string>()) {
    const std::string quantity = value.dump() + " " + meant;
    const auto converted = read_quantity(quantity, unit);
    if (converted && *converted >= least && *converted <= most)
      return fmt::format("write the unit, such as \"{}\": a bare number is in {}", quantity,
                         unit == "rad" ? "radians" : unit);
  }
  const auto written = [&](double limit) {
    constexpr double kDegrees = 57.29577951308232;
    if (unit == "rad") return fmt::format("{:.4g} deg", kDegrees * limit);
    return unit == "1" ? fmt::format("{:.4g}", limit) : fmt::format("{:.4g} {}", limit, unit);
  };
  const bool above = value.get<double>() >= most;
  const bool may_touch = key_schema.contains(above ? "maximum" : "minimum");
  return above ? fmt::format("lower it, to {}{}", may_touch ? "at most " : "less than ", written(most))
               : fmt::format("raise it, to {}{}", may_touch ? "at least " : "more than ", written(least));
}

}  // namespace

Problem wrong_value(const CaseSource& source, const std::string& section, const std::string& key,
                    const OrderedJson& key_schema, const nlohmann::json& value) {
  const std::string type = value_type(key_schema);
  Problem problem{place_of(source, section, key),
                  section + "." + key,
                  value_text(source, section, key),
                  "",
                  allowed_values(key_schema),
                  "",
                  "change the value"};
  const std::string preset = source.tree["algorithm"]["preset"].value_or(std::string());
  if (Schema::has_default(key_schema, preset))
    problem.remedy +=
        fmt::format(", or remove the line to take the default {}", toml_text(Schema::default_in(key_schema, preset)));
  if (key_schema.contains("enum") && value.is_string()) {
    problem.what = "is not a known name";
    if (key_schema.contains("x-limits")) problem.what += ": " + key_schema.at("x-limits").get<std::string>();
    const std::string nearest = nearest_name(value.get<std::string>(), key_schema.at("enum"));
    if (!nearest.empty()) problem.nearest = toml_string(nearest);
  } else if (type == "array" && value.is_array()) {
    problem.what = fmt::format("has {} values, or one that is not allowed", value.size());
  } else if ((type == "number" && value.is_number()) || (type == "integer" && value.is_number_integer())) {
    problem.what = fmt::format("is out of range ({} in SI)", value.dump());
    if (key_schema.contains("x-limits")) problem.what += ": " + key_schema.at("x-limits").get<std::string>();
    if (type == "number") problem.remedy = remedy_of_range(key_schema, value, source.tree[section][key].is_number());
  } else if (type == "string" && value.is_string()) {
    problem.what = "is too long";
  } else {
    problem.what = fmt::format("is a value of another type, not {}",
                               type == "integer" ? "a whole number" : (type == "array" ? "an " : "a ") + type);
  }
  return problem;
}

}  // namespace brash::io
