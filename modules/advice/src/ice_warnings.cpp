// SPDX-License-Identifier: GPL-3.0-or-later
// Ice and water outside their measured ranges: most often a wrong unit.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "brash/core/error.hpp"
#include "brash/core/quantity_text.hpp"
#include "brash/ice/floe_field.hpp"
#include "brash/ice/floe_file.hpp"
#include "brash/ice/idle_files.hpp"
#include "brash/model/plausible.hpp"
#include "case_warnings.hpp"

namespace brash::advice {

bool names_a_basin(std::string source) {
  std::ranges::transform(source, source.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::string_view basins[] = {"basin", "ice tank", "model test", "model ice"};
  return std::ranges::any_of(basins, [&](std::string_view basin) { return source.find(basin) != std::string::npos; });
}

namespace {

using model::Plausible;
using model::Range;

/// Whether the ice may be model ice: it is as thin as sheets of basins are, or the reference names a basin, whose
/// values may be at full scale.
bool may_be_model_ice(const model::Case& c) {
  return names_a_basin(c.reference.source) || model::plausible("ice.thickness").model_ice->has(c.ice.thickness);
}

/// The ranges of a key that hold for the ice of a case.
struct Ranges {
  const Plausible& row;
  bool with_model_ice;

  bool have(double value) const {
    return row.sea.has(value) || (with_model_ice && row.model_ice && row.model_ice->has(value));
  }
  /// Whether the value is plausible in a basin, whether or not the ice may be model ice.
  bool are_of_model_ice(double value) const { return row.model_ice && row.model_ice->has(value); }
};

Ranges ranges_of(const char* key, const model::Case& c) { return {model::plausible(key), may_be_model_ice(c)}; }

std::string in_words(const Range& range, const std::string& unit) {
  return fmt::format("{} to {}", quantity_text(range.least, unit), quantity_text(range.most, unit));
}

/// The value that was probably meant: the number taken in another unit of its kind, the first that is plausible.
std::optional<double> probably_meant(const Ranges& ranges, double value) {
  const std::string_view unit = ranges.row.unit;
  if (unit == "1") return std::nullopt;
  const std::array<double, 3> factors = unit == "Pa"  ? std::array{1e6, 1e3, 1e9}
                                        : unit == "m" ? std::array{1e-2, 1e-3, 1e3}
                                                      : std::array{1e3, 1e-3, 1.0};
  for (const double factor : factors)
    if (factor != 1.0 && ranges.have(factor * value)) return factor * value;
  return std::nullopt;
}

/// The fault of a value of model ice in other ice, and the remedy.
std::string of_other_ice(const Plausible& row) {
  return fmt::format(
      "is of model ice, and the thickness is of ice at sea, which has {} ({}): take the ice of a site, as "
      "`brash new --ice baltic` writes it, or name the basin of a test in reference.source",
      in_words(row.sea, row.unit), row.sea.source);
}

/// The fault of a value that no ice has, and the remedy.
std::string of_no_ice(const Ranges& ranges, double value) {
  const Plausible& row = ranges.row;
  Range all = row.sea;
  std::string known = fmt::format("ice at sea: {}", row.sea.source);
  if (ranges.with_model_ice && row.model_ice) {
    all = {std::min(all.least, row.model_ice->least), std::max(all.most, row.model_ice->most)};
    known += fmt::format("; model ice: {}", row.model_ice->source);
  }
  const std::optional<double> meant = probably_meant(ranges, value);
  return fmt::format("is outside all measured ice: {}; {}", known,
                     meant ? fmt::format("was \"{}\" meant?", quantity_text(*meant, row.unit))
                           : "expected " + in_words(all, row.unit));
}

/// @param name  of the property: the key, if it is the case's own.
void check(const Ranges& ranges, const std::string& name, double value, Warnings& warnings) {
  if (ranges.have(value)) return;
  const std::string found = ranges.are_of_model_ice(value) ? of_other_ice(ranges.row) : of_no_ice(ranges, value);
  warnings.push_back(
      {ranges.row.warning, fmt::format("{} = {} {}", name, quantity_text(value, ranges.row.unit), found)});
}

/// Checks one property of the floes of a file, and names the first that is out of range.
void check_floes(const Ranges& ranges, std::span<const ice::GivenIce> floes,
                 std::optional<double> ice::GivenIce::*property, Warnings& warnings) {
  const auto is_odd = [&](const ice::GivenIce& floe) {
    return (floe.*property).has_value() && !ranges.have(*(floe.*property));
  };
  const auto first = std::ranges::find_if(floes, is_odd);
  if (first == floes.end()) return;
  const auto n = std::ranges::count_if(floes, is_odd);
  const std::string name = std::string(ranges.row.key).substr(std::string_view("ice.").size());
  check(ranges,
        fmt::format("feature {} of field.file{}: {}", first->feature, n > 1 ? fmt::format(" (and {} more)", n - 1) : "",
                    name),
        *((*first).*property), warnings);
}

/// The answer of `read`, or nothing where a file is at fault: it is refused where the ice is laid, and a file that is
/// gone when a run ends takes no result with it.
template <typename Read>
auto or_nothing(Read&& read) -> decltype(read()) {
  try {
    return read();
  } catch (const InputError&) {
    return {};
  }
}

/// Ice of any thickness of either column is plausible: the thickness decides between them.
Ranges thicknesses() { return {model::plausible("ice.thickness"), true}; }

void add_floe_ice_warnings(const model::Case& c, Warnings& warnings) {
  if (c.field.file.empty()) return;
  const auto floes = or_nothing([&] { return ice::read_given_ice(c.field.file); });
  check_floes(thicknesses(), floes, &ice::GivenIce::thickness, warnings);
  check_floes(ranges_of("ice.flexural_strength", c), floes, &ice::GivenIce::flexural_strength, warnings);
}

/// The share of the thickness above water below which a percent of error in a density is half of the freeboard [-].
constexpr double kLeastFreeboard = 0.02;

/// Ice carries less in bending than in compression: its tensile side fails first.
void add_order_warning(const model::IceSection& ice, Warnings& warnings) {
  if (ice.compressive_strength >= ice.flexural_strength) return;
  warnings.push_back({"strengths", fmt::format("ice.compressive_strength = {} is less than ice.flexural_strength = {}, "
                                               "where measured ice carries more in compression: were they swapped?",
                                               quantity_text(ice.compressive_strength, "Pa"),
                                               quantity_text(ice.flexural_strength, "Pa"))});
}

void add_current_warning(Vec2 current, Warnings& warnings) {
  const Plausible& row = model::plausible("water.current");
  if (row.sea.has(norm(current))) return;
  warnings.push_back({row.warning, fmt::format("water.current = [{}, {}] m/s is faster than any that ice is known in, "
                                               "{}: check its unit",
                                               current.x, current.y, row.sea.source)});
}

}  // namespace

void add_ice_warnings(const model::Case& c, Warnings& warnings) {
  const std::pair<const char*, double> properties[] = {{"ice.density", c.ice.density},
                                                       {"ice.flexural_strength", c.ice.flexural_strength},
                                                       {"ice.compressive_strength", c.ice.compressive_strength},
                                                       {"ice.youngs_modulus", c.ice.youngs_modulus},
                                                       {"ice.friction_structure", c.ice.friction_structure}};
  check(thicknesses(), "ice.thickness", c.ice.thickness, warnings);
  for (const auto& [key, value] : properties) check(ranges_of(key, c), key, value, warnings);
  add_order_warning(c.ice, warnings);
  add_floe_ice_warnings(c, warnings);
  add_current_warning(c.water.current, warnings);
  const double freeboard = 1.0 - c.ice.density / c.water.density;
  if (freeboard < kLeastFreeboard)
    warnings.push_back(
        {"hardly-floats", fmt::format("ice.density = {} and water.density = {} kg/m3 leave {:.2g} % of the ice above "
                                      "water, where sea ice has 7 to 12 %: check both",
                                      c.ice.density, c.water.density, 100.0 * freeboard)});
}

void add_idle_file_warnings(const Setup& setup, Warnings& warnings) {
  const model::Case& c = setup.resolved;
  const auto files = or_nothing([&] { return ice::idle_files(c.field, setup.ice); });
  for (const ice::IdleFile& file : files) {
    const bool is_line = file.key == "cracks";
    const std::string does_nothing = is_line            ? "parts no ice"
                                     : file.taken > 0.0 ? fmt::format("takes {:.2g} m2 of ice away", file.taken)
                                                        : "takes no ice away";
    const auto box = [](const geometry::Extent& extent) {
      return fmt::format("from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) m", extent.lower.x, extent.lower.y, extent.upper.x,
                         extent.upper.y);
    };
    warnings.push_back(
        {"off-the-ice", fmt::format("field.{} {}: it reaches {}, and the ice {}; {} field.origin, or check the file's "
                                    "unit and the order of its axes",
                                    file.key, does_nothing, box(file.reach), box(file.ice),
                                    c.field.origin == Vec2{} ? "write" : "correct")});
  }
}

void add_left_out_warnings(const model::Case& c, Warnings& warnings) {
  const model::FieldSection& field = c.field;
  const std::pair<const char*, const std::string&> files[] = {
      {"file", field.file}, {"openings", field.openings}, {"cracks", field.cracks}, {"shore", field.shore}};
  for (const auto& [key, path] : files) {
    if (path.empty()) continue;
    const bool of_lines = &path == &field.cracks;
    const std::string left_out =
        or_nothing([&, &path = path] { return ice::left_out_of(path, field.origin, of_lines); });
    if (!left_out.empty()) warnings.push_back({"left-out", fmt::format("field.{}: left out: {}", key, left_out)});
  }
}

void add_floe_number_warning(const model::Case& c, Warnings& warnings) {
  constexpr double kHaveRun = 1e5, kBytes = 16e3, kSeconds = 20e-6;  // each; docs/performance.md, floes in contact
  if (c.field.kind != model::FieldKind::kFloes || !c.field.file.empty()) return;
  const double n = ice::expected_floes(c.field);
  if (n <= kHaveRun) return;
  warnings.push_back(
      {"many-floes", fmt::format("the field has some {:.2g} floes, more than the {:.0g} that have been run: it takes "
                                 "about {:.2g} GB, and {:.2g} s a step where they touch; check the unit of field.size",
                                 n, kHaveRun, kBytes * n / 1e9, kSeconds * n)});
}

}  // namespace brash::advice
