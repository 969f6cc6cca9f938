// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "brash/geometry/ice_sheet.hpp"
#include "brash/geometry/origin.hpp"

namespace brash::geometry {

/// POLYGON for one polygon, else MULTIPOLYGON, in metres. read_polygons() with the same origin gives back the same grid
/// points in the same order.
///
/// @param origin  where the grid has its zero in the coordinates of the text. Without one, numbers have 17 significant
///                digits, else the fewest decimals that read to the same grid point.
std::string to_wkt(std::span<const Polygon> polygons, const Origin& origin = {});

/// The lines of a text.
struct Lines {
  std::vector<Crack> cracks;          ///< of all lines, in their order
  std::vector<std::size_t> n_cracks;  ///< of each line; 0 if all its positions fall on one grid point
  std::string crs;                    ///< as in Map
  std::string left_out;               ///< as in Map
};

/// Reads the lines of a text as the straight cracks between their positions, in their order.
///
/// WKT: LINESTRING and MULTILINESTRING. GeoJSON: LineString and MultiLineString, alone or in features and collections.
/// Coordinates as in read_polygons(). Two positions on one grid point make no crack.
///
/// @return the lines, or the error as of read_polygons().
tl::expected<Lines, GeometryError> read_lines(std::string_view text, const Origin& origin = {});

/// True when `text` begins as JSON does, after a byte order mark and space.
bool is_json(std::string_view text);

/// One GeoJSON feature.
struct Feature {
  Polygon polygon;
  /// `sheet` or `floe`.
  std::string kind;
  std::int64_t id = 0;
  /// Properties of a floe with ice of its own, [m] and [Pa].
  std::optional<double> thickness{}, flexural_strength{};
  /// Which polygon of its text it is of, from 0; no part of its value.
  std::size_t number = 0;

  friend bool operator==(const Feature& a, const Feature& b) {
    return a.polygon == b.polygon && a.kind == b.kind && a.id == b.id && a.thickness == b.thickness &&
           a.flexural_strength == b.flexural_strength;
  }
};

/// Polygons with their place on the earth.
struct Map {
  std::vector<Feature> features;
  /// Where the grid has its zero, in the coordinates of the file.
  Origin origin;
  /// The member `crs` of a GeoJSON file as it is written; empty where there is none.
  std::string crs;
  /// Nothing says what the coordinates are, and all could be longitudes and latitudes beyond 40 degrees.
  bool looks_like_degrees = false;
  /// Content of the text that the plan cannot hold, such as "heights (12), features without geometry (1)".
  std::string left_out{};

  friend bool operator==(const Map&, const Map&) = default;
};

/// The name in a member `crs`, such as "urn:ogc:def:crs:EPSG::32633"; empty if it has none.
std::string name_of_crs(std::string_view crs);
/// The member `crs` for a code of EPSG, such as 32633.
std::string crs_of_code(std::string_view code);
/// Whether two names represent one coordinate reference system: they have the same code of EPSG, or are the same.
bool are_same_crs(std::string_view a, std::string_view b);

/// Whether the coordinates of a coordinate reference system, such as "urn:ogc:def:crs:EPSG::4326", are longitudes and
/// latitudes. Knows OGC's CRS84, CRS83 and CRS27 and the usual codes of EPSG; no registry is asked.
bool is_geographic(std::string_view name);

/// Why a polygon is not simple on its own, such as "crosses itself at (5, 4.5)"; empty if it is.
std::string fault_of(const Polygon& polygon);

/// The sheet of polygons that fault_of() or IceSheet::from_polygons() has checked: simple and disjoint ones.
IceSheet checked_sheet(std::span<const Polygon> polygons);

/// A FeatureCollection, one feature a line. Properties: `kind`, `id`, `area` [m2] and `area_exact`, every digit of the
/// area as text.
std::string to_geojson(std::span<const Feature> features);
/// The same with the members `crs` and `origin`, where the map has them: read_map() gives back the same map.
std::string map_to_geojson(const Map& map);

/// Reads the polygons of a text onto the grid around `origin`. It checks no ice of the features.
///
/// WKT: POLYGON and MULTIPOLYGON, one or several after one another, lower case and EMPTY too. Heights and measures (Z,
/// M, ZM) are passed over; `SRID=32633;` before a geometry is the code of its coordinate reference system. Polygons of
/// WKT are sheet.
///
/// GeoJSON: a FeatureCollection, Feature, Polygon, MultiPolygon or GeometryCollection, nested up to 64 deep. A
/// geographic `crs`, whose coordinates are degrees, is an error. Without `kind` a feature is `sheet`; without `id`, or
/// with one that is not a whole number, it has its number in the file, from 0; null is as good as none. The members of
/// a multi-part feature share both. Every other property and member is passed over, and so are heights and features
/// without geometry; another geometry is an error.
///
/// Coordinates are plan metres within +-kMaxCoordinate of `origin`. Their difference from it is exact in decimals and
/// is then rounded to the grid. Rings must be closed (the last position equals the first), and have an area or cross
/// themselves; either orientation is read, outlines come out counter-clockwise and holes clockwise. Where rounding
/// alone makes an outline cross itself, it is made simple (without_round_off()); where it leaves a ring no area, the
/// ring is left out. Both are counted in left_out. IceSheet::from_polygons checks that rings neither cross nor overlap.
///
/// @return the map, or the error: "line L, column C: ...", both from 1, columns in bytes.
tl::expected<Map, GeometryError> read_polygons(std::string_view text, const Origin& origin = {});

/// The same with every polygon on a grid of its own: shapes and areas are right, and places mean nothing. So a map may
/// be as wide as it likes, and each of its polygons as wide as a grid.
tl::expected<Map, GeometryError> read_shapes(std::string_view text);

/// The polygons of features, in their order.
std::vector<Polygon> polygons_of(std::span<const Feature> features);

/// Reads the polygons of a text as read_polygons() does, and the ice of its features.
///
/// @param origin  in the coordinates of the text. Without one it is the member `origin` of the text, if all coordinates
///                lie within kMaxCoordinate of it, else zero, if they lie so around it, else the middle of the data,
///                rounded.
/// A `thickness` and a `flexural_strength` must be numbers above 0, or null.
///
/// @return the map, or the error as of read_polygons().
tl::expected<Map, GeometryError> read_map(std::string_view text, const std::optional<Origin>& origin = {});

}  // namespace brash::geometry
