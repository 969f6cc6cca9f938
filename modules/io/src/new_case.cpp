// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/io/new_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "brash/core/error.hpp"
#include "brash/standards/lengths.hpp"
#include "quantity.hpp"
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

/// A quantity of a new case in SI: the value of the site, or else the default or the example of the key.
double quantity(const SiteIce& ice, const std::string& section, const std::string& key) {
  const OrderedJson& key_schema = schema_of_cases().keys(section).at(key);
  const auto of_site = ice.value_of(section + "." + key);
  const OrderedJson value = of_site                          ? OrderedJson::parse(of_site->toml)
                            : key_schema.contains("default") ? key_schema.at("default")
                                                             : key_schema.at("examples").front();
  return value.is_string() ? read_quantity(value.get<std::string>(), key_schema.at("x-unit").get<std::string>()).value()
                           : value.get<double>();
}

/// l_c of the ice [m].
double characteristic_length(const SiteIce& ice) {
  return standards::characteristic_length({.thickness = quantity(ice, "ice", "thickness"),
                                           .youngs_modulus = quantity(ice, "ice", "youngs_modulus"),
                                           .poisson_ratio = quantity(ice, "ice", "poisson_ratio"),
                                           .water_density = quantity(ice, "water", "density")});
}

/// Distance from the axis to the ice edge at the start [m]. The examples are of the validation case, a cone.
double start_distance(const std::string& kind, const SiteIce& ice) {
  if (kind == "ship") return 45.0;
  return kind == "cone" || kind == "faceted-cone" ? quantity(ice, "structure", "start_distance") : 15.0;
}

/// A run that breaks the ice several times, in enough ice for it.
struct Sizes {
  double length = 0.0, width = 0.0;  ///< of the ice [m]
  double duration = 0.0;             ///< [s]
};

double rounded_up(double value, double unit) { return unit * std::ceil(value / unit); }

/// Statistics begin about l_c behind the edge, where the initial crack ends. A break is some 0.4 l_c long. A ship's
/// load is steady when its whole length is in the ice.
Sizes sizes_for(const std::string& kind, const SiteIce& ice) {
  constexpr double kTravel = 6.0, kBorder = 3.0;  // characteristic lengths
  const bool is_ship = kind == "ship", is_round = kind == "cone" || kind == "faceted-cone";
  const double l_c = characteristic_length(ice);
  const double width = is_ship ? quantity(ice, "hull", "breadth") : quantity(ice, "structure", "waterline_width");
  const double length = is_ship    ? quantity(ice, "hull", "length")
                        : is_round ? width
                                   : quantity(ice, "structure", "length");
  const double start = start_distance(kind, ice), speed = quantity(ice, "structure", "speed");
  const double travel = start + l_c + std::max(kTravel * l_c, is_ship ? length : 0.0);
  const double duration = rounded_up(travel / speed, 5.0);
  const double bow_at_end = speed * duration - start + 0.5 * length;
  return {.length = rounded_up(bow_at_end + kBorder * l_c, 10.0),
          .width = rounded_up(width + 2.0 * kBorder * l_c, 10.0),
          .duration = duration};
}

/// The value of a key where it depends on structure and ice; "": the schema's own. The cone in the ice of the basin is
/// the validation case.
std::string fitting_value(const std::string& key, const std::string& kind, const SiteIce& ice) {
  const bool is_validation = ice.name() == "basin" && kind != "ship";
  if (key == "structure.start_distance") return fmt::format("\"{:g} m\"", start_distance(kind, ice));
  // The sides of an icebreaker lean outwards, so that they break ice; a disc that the program cuts first would be wider
  // than the ship.
  if (key == "hull.flare") return "\"8 deg\"";
  if (key == "field.initial_crack") return kind == "ship" ? "false" : "";
  if (is_validation) return "";
  const Sizes sizes = sizes_for(kind, ice);
  if (key == "field.length") return fmt::format("\"{:g} m\"", sizes.length);
  if (key == "field.width") return fmt::format("\"{:g} m\"", sizes.width);
  return key == "time.duration" ? fmt::format("\"{:g} s\"", sizes.duration) : "";
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
    const bool is_of_ships = kind == "ship" && (key == "flare" || key == "initial_crack");
    const bool is_useful = section == "algorithm" || key == "seed" || key == "friction_structure" || is_of_ships;
    if (const auto of_site = ice.value_of(section + "." + key))
      text += commented(of_site->source) + key_line(key, key_schema, of_site->toml);
    else if (is_required || is_particular || is_useful)
      text += key_line(key, key_schema, fitting_value(section + "." + key, kind, ice));
  }
  return text;
}

}  // namespace

std::string new_case(const std::string& kind, const std::string& ice) {
  const SiteIce site(ice);
  const OrderedJson& kinds = schema_of_cases().keys("structure").at("kind").at("enum");
  if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
    throw InputError(Complaint{"--kind", fmt::format("{} is not a kind of structure", kind), kinds.dump(),
                               "name one of these kinds"});
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
