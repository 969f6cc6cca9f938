// SPDX-License-Identifier: GPL-3.0-or-later
// Ice and water outside their measured ranges: most often a wrong unit.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "brash/core/error.hpp"
#include "brash/ice/floe_field.hpp"
#include "brash/ice/floe_file.hpp"
#include "brash/ice/idle_files.hpp"
#include "case_warnings.hpp"
#include "edge_contact.hpp"

namespace brash::simulation {
namespace {

/// Values that have been measured, natural and model ice together.
struct MeasuredRange {
  const char* id;
  const char* key;
  const char* unit;  ///< SI
  double least;
  double most;
  const char* source;
};

// Timco and Weeks 2010: Cold Reg. Sci. Technol. 60, 107 to 129. Timco and Frederking 1996: the same, 24, 1 to 6.
// Sodhi, Borland and Stanley 1996: CRREL Report 96-12. Hu and Zhou 2016: Int. J. Nav. Archit. Ocean Eng. 8(2).
constexpr MeasuredRange kThickness{
    "thickness", "ice.thickness", "m", 0.005, 5.0, "level ice: 24 mm in a basin (Sodhi 1996) to a few metres at sea"};
constexpr MeasuredRange kDensity{"density", "ice.density", "kg/m3",
                                 720.0,     940.0,         "sea ice: 720 to 940 kg/m3 (Timco and Frederking 1996)"};
constexpr MeasuredRange kFlexural{"flexural-strength",
                                  "ice.flexural_strength",
                                  "Pa",
                                  1.0e4,
                                  3.0e6,
                                  "model ice from 31 kPa (Sodhi 1996), sea and fresh ice up to some 2 MPa (Timco and "
                                  "Weeks 2010)"};
constexpr MeasuredRange kCompressive{"compressive-strength",
                                     "ice.compressive_strength",
                                     "Pa",
                                     1.0e4,
                                     2.0e7,
                                     "0.36 to 3.67 MPa (the paper, Sec. 3.1.2), up to 5.4 MPa (Hu and Zhou 2016)"};
constexpr MeasuredRange kModulus{
    "youngs-modulus",
    "ice.youngs_modulus",
    "Pa",
    1.0e7,
    1.2e10,
    "model ice from some 50 MPa (Sodhi 1996), sea ice up to 10 GPa (Timco and Weeks 2010)"};

struct Prefix {
  double factor;
  const char* text;
};

/// `value` in the unit with the prefix that keeps it short.
std::string in_words(double value, const std::string& unit) {
  if (unit == "Pa")
    for (const Prefix& p : {Prefix{1e9, "GPa"}, {1e6, "MPa"}, {1e3, "kPa"}})
      if (value >= p.factor) return fmt::format("{:.4g} {}", value / p.factor, p.text);
  if (unit == "m" && value < 1.0) return fmt::format("{:.4g} cm", 100.0 * value);
  return fmt::format("{:.4g} {}", value, unit);
}

/// The value that was probably meant: the number taken in another unit of its kind, the first that has been measured.
std::optional<double> probably_meant(const MeasuredRange& range, double value) {
  const std::string unit = range.unit;
  const std::array<double, 3> factors = unit == "Pa"  ? std::array{1e6, 1e3, 1e9}
                                        : unit == "m" ? std::array{1e-2, 1e-3, 1e3}
                                                      : std::array{1e3, 1e-3, 1.0};
  for (const double factor : factors)
    if (factor * value >= range.least && factor * value <= range.most && factor != 1.0) return factor * value;
  return std::nullopt;
}

bool is_measured(const MeasuredRange& range, double value) { return value >= range.least && value <= range.most; }

/// @param name  of the property: the key, if it is the case's own.
void check(const MeasuredRange& range, const std::string& name, double value, Warnings& warnings) {
  if (is_measured(range, value)) return;
  const std::optional<double> meant = probably_meant(range, value);
  warnings.push_back({range.id, fmt::format("{} = {} is no ice that has been measured: {}; {}", name,
                                            in_words(value, range.unit), range.source,
                                            meant ? fmt::format("was \"{}\" meant?", in_words(*meant, range.unit))
                                                  : fmt::format("expected {} to {}", in_words(range.least, range.unit),
                                                                in_words(range.most, range.unit)))});
}

/// Checks one property of the floes of a file, and tells of the first that is out of range.
void check_floes(const MeasuredRange& range, std::span<const ice::GivenIce> floes,
                 std::optional<double> ice::GivenIce::*property, Warnings& warnings) {
  const auto is_odd = [&](const ice::GivenIce& floe) {
    return (floe.*property).has_value() && !is_measured(range, *(floe.*property));
  };
  const auto first = std::ranges::find_if(floes, is_odd);
  if (first == floes.end()) return;
  const auto n = std::ranges::count_if(floes, is_odd);
  const std::string name = std::string(range.key).substr(std::string_view("ice.").size());
  check(range,
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

void add_floe_ice_warnings(const model::Case& c, Warnings& warnings) {
  if (c.field.file.empty()) return;
  const auto floes = or_nothing([&] { return ice::read_given_ice(c.field.file); });
  check_floes(kThickness, floes, &ice::GivenIce::thickness, warnings);
  check_floes(kFlexural, floes, &ice::GivenIce::flexural_strength, warnings);
}

/// The share of the thickness above water below which a percent of error in a density is half of the freeboard [-].
constexpr double kLeastFreeboard = 0.02;

/// Ice bears less in bending than in compression: its tensile side fails first.
void add_order_warning(const model::IceSection& ice, Warnings& warnings) {
  if (ice.compressive_strength >= ice.flexural_strength) return;
  warnings.push_back(
      {"strengths", fmt::format("ice.compressive_strength = {} is less than ice.flexural_strength = {}, "
                                "where measured ice bears more in compression: were they swapped?",
                                in_words(ice.compressive_strength, "Pa"), in_words(ice.flexural_strength, "Pa"))});
}

/// Tidal currents among ice reach 8 knots in Cook Inlet (Mulherin and others 2001, ERDC/CRREL TR-01-10) [m/s].
constexpr double kFastestCurrent = 5.0;

void add_current_warning(Vec2 current, Warnings& warnings) {
  if (norm(current) <= kFastestCurrent) return;
  warnings.push_back({"fast-current", fmt::format("water.current = [{}, {}] m/s is faster than any that ice is known "
                                                  "in, some 4 m/s in Cook Inlet: check its unit",
                                                  current.x, current.y)});
}

}  // namespace

void add_ice_warnings(const model::Case& c, Warnings& warnings) {
  check(kThickness, kThickness.key, c.ice.thickness, warnings);
  check(kDensity, kDensity.key, c.ice.density, warnings);
  check(kFlexural, kFlexural.key, c.ice.flexural_strength, warnings);
  check(kCompressive, kCompressive.key, c.ice.compressive_strength, warnings);
  check(kModulus, kModulus.key, c.ice.youngs_modulus, warnings);
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

void add_idle_file_warnings(const model::Case& c, Warnings& warnings) {
  const auto files = or_nothing([&] { return ice::idle_files(c.field, ice_properties(c)); });
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
    const std::string left_out = or_nothing([&] { return ice::left_out_of(path, field.origin, of_lines); });
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

}  // namespace brash::simulation
