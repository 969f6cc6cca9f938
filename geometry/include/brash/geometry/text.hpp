// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "brash/geometry/ice_sheet.hpp"

namespace brash::geometry {

/// POLYGON or MULTIPOLYGON in metres, 17 significant digits, so that reading gives back the same grid points.
std::string to_wkt(std::span<const Polygon> polygons);
/// Reads POLYGON and MULTIPOLYGON; coordinates in metres are rounded to the grid.
/// @return the polygons or what is wrong, with line and column.
tl::expected<std::vector<Polygon>, GeometryError> from_wkt(std::string_view text);

/// One GeoJSON feature.
struct Feature {
  Polygon polygon;
  /// `sheet` or `floe`.
  std::string kind;
  std::int64_t id = 0;
};

/// A FeatureCollection with `kind`, `id` and the exact area as text in each feature's properties.
std::string to_geojson(std::span<const Feature> features);
/// Reads a FeatureCollection, Feature or geometry with polygons.
tl::expected<std::vector<Feature>, GeometryError> from_geojson(std::string_view text);

}  // namespace brash::geometry
