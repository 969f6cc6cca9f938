// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <sstream>
#include <utility>

#include "brash/core/contract.hpp"
#include "brash/io/case.hpp"
#include "brash/model/case_keys.hpp"
#include "schema.hpp"
#include "site_ice.hpp"

namespace brash::io {
namespace {

std::string value_as_toml(double value) { return toml_number(value); }
std::string value_as_toml(int value) { return std::to_string(value); }
std::string value_as_toml(bool value) { return value ? "true" : "false"; }
std::string value_as_toml(const std::string& value) { return toml_string(value); }
template <model::Choice Choice>
std::string value_as_toml(Choice value) {
  return toml_string(std::string(model::name_of(value)));
}
std::string value_as_toml(const Vec2& value) {
  return fmt::format("[{}, {}]", toml_number(value.x), toml_number(value.y));
}
std::string value_as_toml(const std::array<int, 2>& value) { return fmt::format("[{}, {}]", value[0], value[1]); }
std::string value_as_toml(const Vec3& value) {
  return fmt::format("[{}, {}, {}]", toml_number(value.x), toml_number(value.y), toml_number(value.z));
}
std::string value_as_toml(const std::array<double, 6>& v) {
  return fmt::format("[{}, {}, {}, {}, {}, {}]", toml_number(v[0]), toml_number(v[1]), toml_number(v[2]),
                     toml_number(v[3]), toml_number(v[4]), toml_number(v[5]));
}
std::string value_as_toml(const model::Waypoint& w) {
  return fmt::format("[{}, {}, {}, {}]", toml_number(w.time), toml_number(w.position.x), toml_number(w.position.y),
                     toml_number(w.heading));
}
std::string value_as_toml(const model::MooringLine& l) {
  return fmt::format("[{}, {}, {}, {}, {}, {}, {}, {}, {}]", toml_number(l.anchor.x), toml_number(l.anchor.y),
                     toml_number(l.anchor.z), toml_number(l.fairlead.x), toml_number(l.fairlead.y),
                     toml_number(l.fairlead.z), toml_number(l.length), toml_number(l.weight), toml_number(l.stiffness));
}
template <typename Item>
std::string value_as_toml(const std::vector<Item>& items) {
  std::string text;
  for (const Item& item : items) text += (text.empty() ? "" : ", ") + value_as_toml(item);
  return "[" + text + "]";
}
std::string value_as_toml(std::uint64_t value) {
  // TOML's whole numbers are signed; read_case gives no larger seed.
  BRASH_EXPECTS(value <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()), value);
  return std::to_string(value);
}

/// `key = value` with its unit as a comment; nothing for an absent value.
template <typename Value>
std::string key_line(const std::string& key, const Value& value, const std::string& unit) {
  return fmt::format("{} = {}{}\n", key, value_as_toml(value), unit == "1" ? "" : "  # " + unit);
}
template <typename Value>
std::string key_line(const std::string& key, const std::optional<Value>& value, const std::string& unit) {
  return value ? key_line(key, *value, unit) : "";
}
template <typename Item>
std::string key_line(const std::string& key, const std::vector<Item>& items, const std::string& unit) {
  return items.empty() ? "" : fmt::format("{} = {}{}\n", key, value_as_toml(items), unit == "1" ? "" : "  # " + unit);
}

}  // namespace

std::string commented(const std::string& text) {
  constexpr std::size_t kColumns = 100;
  std::istringstream words(text);
  std::string lines;
  std::string line = "#";
  for (std::string word; words >> word;) {
    if (line.size() + 1 + word.size() > kColumns) {
      lines += line + '\n';
      line = "#";
    }
    line += ' ' + word;
  }
  return lines + line + '\n';
}

std::string to_toml(const model::Case& resolved) {
  std::map<std::pair<std::string, std::string>, std::string> lines;
  model::visit_keys(resolved, [&](const std::string& section, const std::string& key, const auto& value) {
    lines[{section, key}] = key_line(key, value, schema_of_cases().keys(section).at(key).value("x-unit", "1"));
  });
  // structure.speed is the short form of this subsection.
  if (std::holds_alternative<model::Towed>(resolved.structure.motion)) lines.erase({"structure.motion", "kind"});
  std::string text = "# A resolved brash case: every key, in SI.\n";
  for (const auto& [section, section_schema] : schema_of_cases().sections().items()) {
    std::string keys;
    for (const auto& [key, key_schema] : section_schema.at("properties").items()) keys += lines[{section, key}];
    const bool is_subsection = section.find('.') != std::string::npos;
    if (!keys.empty() || !is_subsection) text += fmt::format("\n[{}]\n{}", section, keys);
  }
  return text;
}

namespace {

/// The kinds that have a key of which the default kind of the section has none, such as "plane, wedge-bow"; else empty.
std::string other_kinds(const OrderedJson& keys, const OrderedJson& key_schema) {
  if (!key_schema.contains("x-kinds")) return "";
  const auto kinds = key_schema.at("x-kinds").get<std::vector<std::string>>();
  if (std::ranges::find(kinds, keys.at("kind").at("default").get<std::string>()) != kinds.end()) return "";
  return fmt::format("{}", fmt::join(kinds, ", "));
}

/// Whether the section around this one has it by default.
bool has_by_default(const Schema& schema, const std::string& section) {
  const std::string around = section.substr(0, section.rfind('.'));
  if (around == section || !schema.keys(around).contains("kind")) return true;
  return schema.has_section(section, schema.keys(around).at("kind").at("default").get<std::string>());
}

/// The first kind that has a key; the default kind of the section where all kinds have it, or "".
std::string first_kind(const OrderedJson& keys, const OrderedJson& key_schema) {
  if (key_schema.contains("x-kinds")) return key_schema.at("x-kinds").front().get<std::string>();
  return keys.contains("kind") ? keys.at("kind").at("default").get<std::string>() : "";
}

}  // namespace

std::string case_template(const std::string& ice) {
  const SiteIce site(ice);
  std::string text = kSchemaLine;
  text += commented(
      "A brash case with every key. A bare number is SI; a string is a quantity with a unit, such as \"33 cm\". Keys "
      "without a default are required and have the values of the validation case here; other lines may be removed. "
      "Ice: " +
      site.description() + ".");
  const Schema& schema = schema_of_cases();
  for (const auto& [section, section_schema] : schema.sections().items()) {
    text += "\n" + commented(section_schema.at("description").get<std::string>()) + "[" + section + "]\n";
    for (const auto& [key, key_schema] : schema.keys(section).items()) {
      const bool required = schema.requires_key(section, key, first_kind(schema.keys(section), key_schema));
      const std::string kinds = other_kinds(schema.keys(section), key_schema);
      text += commented(key_schema.at("description").get<std::string>());
      const std::string of_kinds = kinds.empty() ? "" : " with kind = " + kinds;
      text += commented((required ? "Required" : "Optional") + of_kinds + ": " + allowed_values(key_schema) + ".");
      if (const std::string plausible = plausible_values(key_schema); !plausible.empty())
        text += commented(plausible + " " + plausible_sources(key_schema));
      const bool has_default = key_schema.contains("default");
      const auto of_site = site.value_of(section + "." + key);
      if (of_site) text += commented(fmt::format("Ice ({}): {}", site.name(), of_site->source));
      const std::string value = of_site       ? of_site->toml
                                : has_default ? toml_text(key_schema.at("default"))
                                              : toml_text(key_schema.at("examples").front());
      const bool is_live = kinds.empty() && (required || has_default) && has_by_default(schema, section);
      text += fmt::format("{}{} = {}\n", is_live ? "" : "# ", key, value);
    }
  }
  return text;
}

}  // namespace brash::io
