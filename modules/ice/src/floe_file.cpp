// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/ice/floe_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <utility>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/geometry/ice_sheet.hpp"
#include "brash/geometry/repair.hpp"
#include "brash/geometry/text.hpp"

namespace brash::ice {
namespace {

using Json = nlohmann::json;

constexpr const char* kAllowed = "POLYGON or MULTIPOLYGON in WKT, or a GeoJSON FeatureCollection, in metres";

[[noreturn]] void refuse(const std::string& where, const std::string& what, const std::string& allowed,
                         const std::string& remedy) {
  throw InputError(Complaint{where, what, allowed, remedy});
}

/// What helps where a text cannot be read: the key field.origin, if its polygons would be read somewhere else.
std::string remedy_of(const std::string& text) {
  const auto map = geometry::read_map(text);
  if (!map || map->origin == geometry::Origin{} || map->features.empty()) return "correct the file";
  geometry::Extent box;
  for (const geometry::Feature& feature : map->features) box.add(geometry::extent(feature.polygon));
  const double x = map->origin.x.nearest_double() + std::floor(box.lower.x);
  const double y = map->origin.y.nearest_double() + std::round(0.5 * (box.lower.y + box.upper.y));
  return fmt::format("write field.origin = [{:.0f}, {:.0f}]: the data then begin at x = 0 and lie around y = 0", x, y);
}

/// The polygons of a text, in its order; WKT knows no kinds, and no floes.
std::vector<geometry::Feature> features_of(const std::string& text, const std::string& path, Vec2 origin) {
  auto read = geometry::read_polygons(text, geometry::origin_from_metres(origin));
  if (!read) refuse(path, read.error().what, kAllowed, remedy_of(text));
  if (read->features.empty()) refuse(path, "holds no polygon", kAllowed, "name another file");
  return std::move(read->features);
}

/// The polygons of a text, in its order.
std::vector<geometry::Polygon> polygons_of(const std::string& text, const std::string& path, Vec2 origin) {
  return geometry::polygons_of(features_of(text, path, origin));
}

/// The command that makes a file without faults of this one.
std::string repair_of(const std::string& path) {
  return fmt::format("repair the file: brash crack --sheet {} --repair -o NEW", path);
}

void expect_no_overlap(const std::vector<geometry::Polygon>& polygons, const std::string& path) {
  const auto sheet = geometry::IceSheet::from_polygons(polygons);
  if (!sheet)
    refuse(path, sheet.error().what + " (polygons count from 0)", "simple outlines that do not overlap",
           "move or cut one (outlines may touch), or " + repair_of(path));
}

/// How many polygons a geometry has; null has none.
std::size_t n_polygons(const Json& geometry) {
  if (!geometry.is_object()) return 0;
  const std::string type = geometry.value("type", "");
  if (type == "MultiPolygon") return geometry.at("coordinates").size();
  if (type != "GeometryCollection") return 1;
  std::size_t sum = 0;
  for (const Json& part : geometry.at("geometries")) sum += n_polygons(part);
  return sum;
}

std::optional<double> property(const Json& feature, std::size_t number, const char* name, double least, double most,
                               const char* unit, const std::string& path) {
  if (!feature.contains("properties") || !feature.at("properties").is_object()) return std::nullopt;
  const Json& properties = feature.at("properties");
  if (!properties.contains(name) || properties.at(name).is_null()) return std::nullopt;
  const Json& value = properties.at(name);
  const bool is_good = value.is_number() && value.get<double>() >= least && value.get<double>() <= most;
  if (!is_good)
    refuse(fmt::format("{}, feature {}", path, number), fmt::format("has the {} {}", name, value.dump()),
           fmt::format("a number from {:g} to {:g} in {}", least, most, unit),
           fmt::format("correct the property, or remove it to take the {} of the case", name));
  return value.get<double>();
}

std::string in_small_letters(std::string text) {
  for (char& letter : text)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return text;
}

/// Programs for maps like to change the letters of names.
void expect_known_letters(const Json& feature, std::size_t number, const std::string& path) {
  if (!feature.contains("properties") || !feature.at("properties").is_object()) return;
  const Json& properties = feature.at("properties");
  for (const auto& [name, value] : properties.items())
    for (const std::string known : {"thickness", "flexural_strength", "kind"}) {
      if (in_small_letters(name) != known || properties.contains(known)) continue;
      if (known == "kind" && value != "floe") continue;  // of something else
      refuse(fmt::format("{}, feature {}", path, number),
             fmt::format("has the property {}, which has no effect in these letters", name),
             "thickness, flexural_strength and kind in small letters",
             fmt::format("write {}, or remove the property", known));
    }
}

/// The features of GeoJSON; none of a text that has none.
Json features_in(const Json& root) {
  const std::string type = root.is_object() && root.contains("type") ? root.at("type").dump() : "";
  if (type == R"("Feature")") return Json::array({root});
  return type == R"("FeatureCollection")" && root.contains("features") ? root.at("features") : Json::array();
}

GivenIce given_ice(const Json& feature, std::size_t number, const std::string& path) {
  return {number, property(feature, number, "thickness", 1e-3, 10.0, "m", path),
          property(feature, number, "flexural_strength", 1e-3, 1e8, "Pa", path)};
}

/// Adds the properties of the features of a text.
/// @param read  the polygons of the text, one a floe.
void add_properties(const std::string& text, const std::string& path, const std::vector<geometry::Feature>& read,
                    std::vector<GivenFloe>& floes) {
  const Json features = features_in(Json::parse(text));
  std::size_t floe = 0, n_before = 0, number = 0;
  for (const Json& feature : features) {
    expect_known_letters(feature, number, path);
    const GivenIce ice = given_ice(feature, number, path);
    n_before += n_polygons(feature.value("geometry", Json()));
    for (; floe < floes.size() && read[floe].number < n_before; ++floe) {
      floes[floe].thickness = ice.thickness;
      floes[floe].flexural_strength = ice.flexural_strength;
    }
    ++number;
  }
}

void expect_in_field(const std::vector<GivenFloe>& floes, const model::FieldSection& field, const std::string& path) {
  for (std::size_t i = 0; i < floes.size(); ++i) {
    const auto [lower, upper] = geometry::extent(floes[i].outline);
    if (lower.x >= 0.0 && upper.x <= field.length && std::max(-lower.y, upper.y) <= 0.5 * field.width) continue;
    refuse(fmt::format("{}, polygon {} (counted from 0)", path, i),
           fmt::format("reaches from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) m, out of the field", lower.x, lower.y,
                       upper.x, upper.y),
           fmt::format("x from 0 to field.length = {} m, y within +-field.width/2 = {} m", field.length,
                       0.5 * field.width),
           "write field.origin for the coordinates of a map, move the ice, or enlarge the field");
  }
}

}  // namespace

std::vector<geometry::Polygon> read_outlines(const std::string& path, Vec2 origin) {
  std::vector<geometry::Polygon> polygons = polygons_of(read_characters(path, "file of outlines"), path, origin);
  expect_no_overlap(polygons, path);
  return polygons;
}

std::vector<GivenFloe> read_floes(const std::string& path, const model::FieldSection& field) {
  const std::string text = read_characters(path, "file of floes");
  const std::vector<geometry::Feature> features = features_of(text, path, field.origin);
  expect_no_overlap(geometry::polygons_of(features), path);
  std::vector<GivenFloe> floes;
  for (const geometry::Feature& feature : features) floes.push_back({feature.polygon, {}, {}});
  if (geometry::is_json(text)) add_properties(text, path, features, floes);
  expect_in_field(floes, field, path);
  return floes;
}

std::vector<GivenIce> read_given_ice(const std::string& path) {
  const std::string text = read_characters(path, "file of floes");
  std::vector<GivenIce> all;
  if (!geometry::is_json(text)) return all;
  std::size_t number = 0;
  for (const Json& feature : features_in(Json::parse(text, nullptr, false)))
    if (const GivenIce ice = given_ice(feature, number++, path); ice.thickness || ice.flexural_strength)
      all.push_back(ice);
  return all;
}

GivenLevelIce read_level_ice(const std::string& path, const model::FieldSection& field) {
  const std::string text = read_characters(path, "file of level ice");
  const std::vector<geometry::Feature> features = features_of(text, path, field.origin);
  std::vector<GivenFloe> all;
  for (const geometry::Feature& feature : features) all.push_back({feature.polygon, {}, {}});
  expect_no_overlap(geometry::polygons_of(features), path);
  if (geometry::is_json(text)) add_properties(text, path, features, all);
  expect_in_field(all, field, path);
  GivenLevelIce ice;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (features[i].kind == "floe") {
      ice.floes.push_back(std::move(all[i]));
      continue;
    }
    if (all[i].thickness || all[i].flexural_strength)
      refuse(fmt::format("{}, polygon {} (counted from 0)", path, i), "is level ice with ice properties of its own",
             "thickness and flexural_strength of floes only",
             "remove the property; level ice has the ice of the case, and varies by [ice.variation]");
    ice.sheets.push_back(std::move(all[i].outline));
  }
  if (ice.sheets.empty())
    refuse(path, "holds floes alone", "a polygon of level ice: one whose property kind is not \"floe\"",
           "write field.kind = \"floes\", or add the level ice");
  return ice;
}

std::vector<geometry::Polygon> read_openings(const std::string& path, Vec2 origin) {
  std::vector<geometry::Polygon> polygons = polygons_of(read_characters(path, "file of openings"), path, origin);
  if (const auto faults = geometry::own_faults_of(polygons); !faults.empty())
    refuse(path, geometry::text_of(faults) + " (polygons count from 0)",
           "simple outlines, which may overlap each other", "correct the polygons, or " + repair_of(path));
  return polygons;
}

std::string left_out_of(const std::string& path, Vec2 origin, bool of_lines) {
  const std::string text = read_characters(path, "file of the ice");
  const geometry::Origin place = geometry::origin_from_metres(origin);
  if (of_lines) return geometry::read_lines(text, place).value_or(geometry::Lines{}).left_out;
  return geometry::read_polygons(text, place).value_or(geometry::Map{}).left_out;
}

std::vector<geometry::Crack> read_cracks(const std::string& path, Vec2 origin) {
  const std::string text = read_characters(path, "file of cracks");
  auto lines = geometry::read_lines(text, geometry::origin_from_metres(origin));
  if (!lines)
    refuse(path, lines.error().what, "LINESTRING or MULTILINESTRING in WKT, or their like in GeoJSON, in metres",
           "correct the line; areas of open water go to field.openings; the coordinates of a map need field.origin");
  if (lines->cracks.empty())
    refuse(path, "holds no line", "one line or more", "name another file, or remove field.cracks");
  return std::move(lines->cracks);
}

}  // namespace brash::ice
