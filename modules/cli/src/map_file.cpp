// SPDX-License-Identifier: GPL-3.0-or-later
#include "map_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"
#include "brash/core/write_file.hpp"
#include "messages.hpp"

namespace brash::cli {
namespace {

using geometry::Map;
using geometry::Origin;

bool is_wkt(const std::string& path) { return std::filesystem::path(path).extension() == ".wkt"; }

std::string to_lines_of_wkt(const Map& map) {
  std::string text;
  for (const geometry::Feature& f : map.features) text += geometry::to_wkt(std::span(&f.polygon, 1), map.origin) + '\n';
  return text.empty() ? geometry::to_wkt({}) + '\n' : text;
}

}  // namespace

void refuse_polygons(const std::string& where, const std::string& what) {
  throw InputError(
      Complaint{where, what,
                "POLYGON or MULTIPOLYGON (WKT) or their like in GeoJSON: closed rings of finite metres "
                "that neither cross nor overlap, holes inside their outline; properties as docs/reference/command.md "
                "lists them",
                "correct what is named; docs/reference/command.md describes such files"});
}

std::optional<Origin> origin_option(const std::string& command, const std::string& value) {
  if (value.empty()) return std::nullopt;
  const auto origin = geometry::origin_from_text(value);
  if (!origin) {
    throw InputError(Complaint{command, fmt::format("--origin = '{}' is no place", printable(value)),
                               "X,Y in the coordinates of the file, such as 500000,7000000", "change the option"});
  }
  return origin;
}

std::string crs_member(const std::string& name) {
  constexpr std::string_view kEpsg = "EPSG:";
  const bool is_code = name.size() > kEpsg.size() && name.starts_with(kEpsg) &&
                       name.find_first_not_of("0123456789", kEpsg.size()) == std::string::npos;
  if (!is_code || geometry::is_geographic(name))
    throw InputError(Complaint{
        "--crs", fmt::format("'{}' is {}", printable(name), is_code ? "a system of degrees" : "no code of a system"),
        "EPSG:CODE of a projected system in metres, such as EPSG:32633",
        "name the system that field.origin belongs to"});
  return geometry::crs_of_code(std::string_view(name).substr(kEpsg.size()));
}

Map read_map_file(const std::string& path, const std::optional<Origin>& origin) {
  auto map = geometry::read_map(read_characters(path, "a sheet (WKT or GeoJSON)", kMostMebibytes), origin);
  if (!map) refuse_polygons(path, map.error().what);
  say_left_out(path, map->left_out);
  return *std::move(map);
}

void say_left_out(const std::string& path, const std::string& left_out) {
  if (!left_out.empty()) say("note: {}: left out: {}\n", path, left_out);
}

void say_place(const std::string& path, const Map& map, bool origin_is_given) {
  if (map.looks_like_degrees) {
    say("warning: degrees: {}: all coordinates could be longitudes and latitudes. They are read as metres. Project "
        "such "
        "a file first (ogr2ogr -t_srs EPSG:CODE), or give --origin 0,0 if they are metres\n",
        path);
  }
  if (!origin_is_given && map.origin != Origin{}) say("{}: the origin is {}\n", path, to_string(map.origin));
}

void check_map_name(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension();
  constexpr std::array<std::string_view, 4> kKnown{"", ".geojson", ".json", ".wkt"};
  if (std::ranges::find(kKnown, ending) != kKnown.end()) return;
  throw InputError(Complaint{path, fmt::format("'{}' is no format that is written", printable(ending)),
                             "a name that ends in .geojson or .json (GeoJSON) or in .wkt (WKT)",
                             "change the name; ogr2ogr makes other formats of GeoJSON"});
}

void write_map_file(const std::string& path, const Map& map) {
  if (!is_wkt(path)) return write_file(path, geometry::map_to_geojson(map));
  write_file(path, to_lines_of_wkt(map));
  const auto is_floe = [](const geometry::Feature& f) { return f.kind == "floe"; };
  const bool is_mixed = std::ranges::any_of(map.features, is_floe);
  if (is_mixed || !map.crs.empty()) {
    say("{}: WKT has no kinds, ids and coordinate reference system; every polygon is read back as sheet. GeoJSON keeps "
        "them\n",
        path);
  }
}

}  // namespace brash::cli
