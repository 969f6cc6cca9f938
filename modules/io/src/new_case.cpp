// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/io/new_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "brash/core/error.hpp"
#include "schema.hpp"
#include "site_ice.hpp"

namespace brash::io {
namespace {

/// The first sentence of a description. A dot before a number ends none: "Eqs. 15 and 16".
std::string first_sentence(const std::string& description) {
  std::size_t end = description.find(". ");
  while (end != std::string::npos && std::isdigit(static_cast<unsigned char>(description[end + 2])) != 0)
    end = description.find(". ", end + 1);
  return end == std::string::npos ? description : description.substr(0, end + 1);
}

/// A start ahead of the ice, and room for a ship: the examples are those of the validation case, a cone.
std::string fitting_value(const std::string& key, const std::string& kind) {
  if (key == "start_distance" && kind != "cone" && kind != "faceted-cone")
    return kind == "ship" ? "\"45 m\"" : "\"15 m\"";
  if (kind == "ship" && key == "duration") return "\"60 s\"";
  if (kind == "ship" && (key == "field.length" || key == "field.width")) return "\"150 m\"";
  return "";
}

/// `key = value  # meaning and plausible values`, with the default of the key, or else its example.
std::string key_line(const std::string& key, const OrderedJson& key_schema, const std::string& fitting) {
  const bool has_default = key_schema.contains("default");
  const std::string value = toml_text(has_default ? key_schema.at("default") : key_schema.at("examples").front());
  const std::string plausible = plausible_values(key_schema);
  return fmt::format("{:<32}  # {}{}\n", key + " = " + (fitting.empty() ? value : fitting),
                     first_sentence(key_schema.at("description").get<std::string>()),
                     plausible.empty() ? "" : " " + plausible);
}

/// The particulars that come together.
constexpr int kParticulars = 5;

/// The keys of a section that a new case with this kind of structure, in this ice, writes.
std::string section_keys(const std::string& section, const std::string& kind, const SiteIce& ice) {
  const Schema& schema = schema_of_cases();
  std::string text;
  int n = 0;
  for (const auto& [key, key_schema] : schema.keys(section).items()) {
    if (section == "structure" && key == "kind") {
      text += fmt::format("kind = {}\n", toml_string(kind));
      continue;
    }
    const std::string of = section == "structure" ? kind : "";
    const bool is_required = schema.has_key(section, key, of) && schema.requires_key(section, key, of);
    const bool is_particular = section == "hull" && kind == "ship" && n++ < kParticulars;
    const bool is_useful = section == "algorithm" || key == "seed" || (section == "ice" && key == "friction_structure");
    if (const auto of_site = ice.value_of(section + "." + key))
      text += commented(of_site->source) + key_line(key, key_schema, of_site->toml);
    else if (is_required || is_particular || is_useful)
      text += key_line(key, key_schema, fitting_value(section == "field" ? "field." + key : key, kind));
  }
  return text;
}

}  // namespace

std::string new_case(const std::string& kind, const std::string& ice) {
  const SiteIce site(ice);
  const OrderedJson& kinds = schema_of_cases().keys("structure").at("kind").at("enum");
  if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
    throw InputError(
        Complaint{"--kind", fmt::format("{} is no kind of structure", kind), kinds.dump(), "name one of these kinds"});
  std::string text = kSchemaLine;
  text += fmt::format(
      "# A brash case. A bare number is SI; a string is a quantity with a unit.\n"
      "# `brash schema --template` lists every other key; `brash check` reads this file.\n"
      "# Ice: {}.\n",
      site.description());
  for (const auto& [section, section_schema] : schema_of_cases().sections().items())
    // A structure that is towed has its speed in [structure].
    if (const std::string keys = section_keys(section, kind, site); section != "structure.motion" && !keys.empty())
      text += fmt::format("\n[{}]\n{}", section, keys);
  return text;
}

}  // namespace brash::io
