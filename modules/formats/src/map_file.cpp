// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"
#include "brash/formats/maps.hpp"

namespace brash::formats {
namespace {

using geometry::Map;
using geometry::Origin;

bool is_wkt(const std::string& path) { return std::filesystem::path(path).extension() == ".wkt"; }

std::string to_lines_of_wkt(const Map& map) {
  std::string text;
  for (const geometry::Feature& f : map.features) text += geometry::to_wkt(std::span(&f.polygon, 1), map.origin) + '\n';
  return text.empty() ? geometry::to_wkt({}) + '\n' : text;
}

/// The GeoJSON member `crs` for a name such as EPSG:32633.
/// @throws InputError for another name, and for a system of degrees.
std::string crs_member(const std::string& name) {
  constexpr std::string_view kEpsg = "EPSG:";
  const bool is_code = name.size() > kEpsg.size() && name.starts_with(kEpsg) &&
                       name.find_first_not_of("0123456789", kEpsg.size()) == std::string::npos;
  if (!is_code || geometry::is_geographic(name))
    throw InputError(Complaint{
        "--crs", fmt::format("'{}' is {}", printable(name), is_code ? "a system of degrees" : "not a code of a system"),
        "EPSG:CODE of a projected system in metres, such as EPSG:32633",
        "name the system that field.origin belongs to"});
  return geometry::crs_of_code(std::string_view(name).substr(kEpsg.size()));
}

}  // namespace

void refuse_polygons(const std::string& where, const std::string& what) {
  throw InputError(Complaint{
      where, what,
      "POLYGON or MULTIPOLYGON (WKT) or their like in GeoJSON: closed rings of finite metres "
      "that neither cross nor overlap, holes inside their outline; properties as docs/reference/command.md "
      "lists them",
      "correct what is named; crossings and overlaps are repaired by brash crack --sheet FILE --repair -o NEW"});
}

Map read_map_file(const std::string& path, const std::optional<Origin>& origin) {
  auto map = geometry::read_map(read_characters(path, "a sheet (WKT or GeoJSON)", kMostMebibytes), origin);
  if (!map) refuse_polygons(path, map.error().what);
  return *std::move(map);
}

void check_map_name(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension();
  constexpr std::array<std::string_view, 4> kKnown{"", ".geojson", ".json", ".wkt"};
  if (std::ranges::find(kKnown, ending) != kKnown.end()) return;
  throw InputError(Complaint{path, fmt::format("'{}' is not a format that is written", printable(ending)),
                             "a name that ends in .geojson or .json (GeoJSON) or in .wkt (WKT)",
                             "change the name; ogr2ogr makes other formats of GeoJSON"});
}

std::string to_map_text(const std::string& path, const Map& map) {
  return is_wkt(path) ? to_lines_of_wkt(map) : geometry::map_to_geojson(map);
}

bool loses_knowledge(const std::string& path, const Map& map) {
  const auto is_floe = [](const geometry::Feature& f) { return f.kind == "floe"; };
  return is_wkt(path) && (std::ranges::any_of(map.features, is_floe) || !map.crs.empty());
}

void take_crs(Map& map, const std::string& name) {
  const std::string given = crs_member(name), own = geometry::name_of_crs(map.crs);
  if (!own.empty() && !geometry::are_same_crs(own, geometry::name_of_crs(given)))
    throw InputError(Complaint{fmt::format("--crs={}", name), fmt::format("the ice of the run has the crs {}", own),
                               "the crs of field.file", "leave --crs out, and project the map afterwards"});
  map.crs = given;
}

}  // namespace brash::formats
