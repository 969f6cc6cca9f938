// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "brash/geometry/ice_sheet.hpp"

namespace brash::geometry {

/// POLYGON for one polygon, else MULTIPOLYGON, in metres with 17 significant digits: from_wkt() gives back the same
/// grid points in the same order.
std::string to_wkt(std::span<const Polygon> polygons);

/// Reads POLYGON and MULTIPOLYGON geometries, one or several after one another; lower case and EMPTY too.
///
/// Coordinates are plan metres within +-kMaxCoordinate and are rounded to the grid. Rings must be closed (the last
/// position equals the first) and keep an area on the grid; either orientation is read, outlines come out
/// counter-clockwise and holes clockwise. IceSheet::from_polygons checks that rings neither cross nor overlap.
///
/// @return the polygons, or the error: "line L, column C: ...", both from 1, columns in bytes.
tl::expected<std::vector<Polygon>, GeometryError> from_wkt(std::string_view text);

/// Reads LINESTRING and MULTILINESTRING geometries, one or several after one another, as the straight cracks between
/// their positions, in their order. Coordinates as in from_wkt(). Two positions on one grid point make no crack.
///
/// @return the cracks, or the error as of from_wkt().
tl::expected<std::vector<Crack>, GeometryError> cracks_from_wkt(std::string_view text);

/// One GeoJSON feature.
struct Feature {
  Polygon polygon;
  /// `sheet` or `floe`.
  std::string kind;
  std::int64_t id = 0;

  friend bool operator==(const Feature&, const Feature&) = default;
};

/// A FeatureCollection, one feature a line, with `kind`, `id` and the exact area [m2] as text in the properties.
std::string to_geojson(std::span<const Feature> features);

/// Reads a FeatureCollection, Feature, Polygon, MultiPolygon or GeometryCollection, nested up to 64 deep.
///
/// Rings as in from_wkt(). Without `kind` a feature is `sheet`, without `id` it has its number in the file, from 0; the
/// members of a multi-part feature share both. Every other property and member is passed over; another geometry, a
/// height in a position or a feature without geometry is an error, also with line and column.
tl::expected<std::vector<Feature>, GeometryError> from_geojson(std::string_view text);

}  // namespace brash::geometry
