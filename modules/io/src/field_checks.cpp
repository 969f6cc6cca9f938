// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>

#include "brash/model/case_keys.hpp"
#include "checks.hpp"

namespace brash::io {
namespace {

void check_extent(const model::Case& c, Checks& checks) {
  checks.require(c.field.length > c.ice.thickness, {"field", "length"}, {"ice", "thickness"},
                 "the sheet is shorter than it is thick",
                 fmt::format("more than ice.thickness = {} m", c.ice.thickness), "lengthen the sheet");
  checks.require(c.field.initial_crack_radius < std::min(c.field.length, c.field.width / 2.0),
                 {"field", "initial_crack_radius"}, {"field", "length"}, "the initial crack does not fit in the sheet",
                 fmt::format("less than the sheet's length and half its width, {} m",
                             std::min(c.field.length, c.field.width / 2.0)),
                 "lower the radius, or write 0 for the ice's own breaking length");
  checks.require(c.field.border == model::Border::kFixed || c.contact.engine == model::ContactEngine::kBrash,
                 {"field", "border"}, {"contact", "engine"}, "Bullet knows no sheet that drifts",
                 "free with contact.engine = \"brash\"", "take this engine, or border = \"fixed\"");
}

/// The first edge is drawn for the rectangle alone, and in a number of corners that can be cut.
void check_edge(const model::Case& c, Checks& checks) {
  const double roughness = c.field.edge_roughness;
  if (roughness == 0.0) return;
  checks.require(c.field.file.empty(), {"field", "edge_roughness"}, {"field", "file"},
                 "cannot be combined with field.file, whose outlines have their own edge", "one of the two",
                 "remove one of the two, or draw the edge in the file");
  checks.require(roughness <= 0.1 * c.field.length, {"field", "edge_roughness"}, {"field", "length"},
                 "is more than a tenth of the sheet's length", fmt::format("at most {} m", 0.1 * c.field.length),
                 "lower it, or lengthen the sheet");
  const double least = 1e-3 * c.field.width, used = model::edge_correlation_length(c);
  checks.require(used >= least, {"field", "edge_correlation_length"}, {"field", "width"},
                 fmt::format("{} m are less than a thousandth of the sheet's width", used),
                 fmt::format("at least {} m", least), "raise it, or narrow the sheet");
}

/// Each law of sizes needs its own keys, and floes that fit in the field.
void check_sizes(const model::Case& c, Checks& checks) {
  const model::FloeSizes& size = c.field.floes.size;
  const auto needs = [&](bool given, const char* key) {
    checks.require(given, {"field.size", key}, {"field", "kind"}, "is missing: generated floes need a size",
                   "the keys of one law of sizes", "write it under [field.size], or name a field.file");
  };
  double largest = 0.0;
  switch (size.kind) {
    case model::SizeLaw::kPowerLaw:
      needs(size.least.has_value(), "least");
      needs(size.largest.has_value(), "largest");
      largest = size.largest.value_or(0.0);
      checks.require(size.least.value_or(0.0) < size.largest.value_or(1e9), {"field.size", "least"},
                     {"field.size", "largest"}, "is not less than the largest size", "less than field.size.largest",
                     "lower it; floes of one size are kind = \"list\" with one value");
      break;
    case model::SizeLaw::kLogNormal:
      needs(size.median.has_value(), "median");
      largest = size.median.value_or(0.0);
      break;
    case model::SizeLaw::kList:
      needs(!size.values.empty(), "values");
      for (const double value : size.values) largest = std::max(largest, value);
      break;
  }
  checks.require(largest < std::min(c.field.length, c.field.width), {"field", "length"}, {"field", "width"},
                 fmt::format("floes of {:.4g} m do not fit in the field", largest),
                 fmt::format("length and width above {:.4g} m", largest), "enlarge the field, or lower field.size");
}

void check_files(const model::Case& c, Checks& checks) {
  model::visit_files_of_field(c.field, [&](const char* key, const std::string& file) {
    std::error_code ignored;
    checks.require(file.empty() || std::filesystem::is_regular_file(file, ignored), {"field", key}, {"field", key},
                   fmt::format("there is no file {}", file), "a file in WKT or GeoJSON, relative to the case file",
                   "correct the path");
  });
  checks.require(!model::has_ice_files(c.field) || !c.field.initial_crack, {"field", "initial_crack"},
                 {"field", "file"}, "cannot be combined with files of the ice, which may have any edge",
                 "false with field.file, openings, cracks or shore",
                 "remove it, or draw the broken part into field.openings");
}

void check_floes(const model::Case& c, Checks& checks) {
  if (c.field.kind != model::FieldKind::kFloes) return;
  const model::FloeFieldSection& floes = c.field.floes;
  const Key concentration{"field", "concentration"}, kind{"field", "kind"};
  checks.require(floes.concentration.has_value() || !c.field.file.empty(), concentration, kind,
                 "is missing: floes are generated, or read from a file", "a concentration, or field.file",
                 "write field.concentration = 0.7 or the like, or name a file");
  checks.require(!floes.concentration.has_value() || c.field.file.empty(), concentration, kind,
                 "cannot be combined with field.file, whose floes have their own", "one of the two",
                 "remove one of the two");
  if (c.field.file.empty()) check_sizes(c, checks);
}

/// A circle of a few units of the geometry's grid has no shape.
void check_initial_crack(const model::Case& c, Checks& checks) {
  constexpr double kLeast = 0.01;  // [m]
  const double radius = c.field.initial_crack_radius;
  checks.require(radius == 0.0 || radius >= kLeast, {"field", "initial_crack_radius"},
                 {"field", "initial_crack_radius"}, "is too small for a crack",
                 fmt::format("0, or at least {} m", kLeast),
                 "raise the radius, or write 0 for the ice's own breaking length");
}

}  // namespace

void check_field(const model::Case& c, FieldFiles files, Checks& checks) {
  check_extent(c, checks);
  check_initial_crack(c, checks);
  check_edge(c, checks);
  if (files == FieldFiles::kMayBeGone) return;
  check_files(c, checks);
  check_floes(c, checks);
}

}  // namespace brash::io
