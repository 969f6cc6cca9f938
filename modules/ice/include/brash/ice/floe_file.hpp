// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "brash/geometry/ice_sheet.hpp"
#include "brash/model/case.hpp"

namespace brash::ice {

/// A floe of a file.
struct GivenFloe {
  geometry::Polygon outline;
  std::optional<double> thickness;          ///< [m]; absent: of the case
  std::optional<double> flexural_strength;  ///< [Pa]; absent: of the case
};

/// Reads floes from WKT or GeoJSON; the first character says which. The properties `thickness` and
/// `flexural_strength` of a GeoJSON feature are the ones of its floes.
///
/// @param field  whose rectangle holds every floe, and whose origin is taken from the file's coordinates, exactly.
/// @throws InputError naming file and place when the text is at fault, floes overlap, a floe leaves the field, a
///         property is out of range, or has a known name in other letters.
std::vector<GivenFloe> read_floes(const std::string& path, const model::FieldSection& field);

/// The ice that a feature of GeoJSON states for its floes.
struct GivenIce {
  std::size_t feature = 0;                  ///< its number, from 0
  std::optional<double> thickness;          ///< [m]
  std::optional<double> flexural_strength;  ///< [Pa]
};

/// Reads these properties alone, which is quick. A text that is not GeoJSON has none.
/// @throws InputError when the file cannot be read, or a property is out of range.
std::vector<GivenIce> read_given_ice(const std::string& path);

/// Level ice of a file.
struct GivenLevelIce {
  std::vector<geometry::Polygon> sheets;
  std::vector<GivenFloe> floes;  ///< beside the sheets
};

/// Reads level ice from such a file. Features of GeoJSON with the property `kind` = "floe" are floes, as
/// geometry::to_geojson() writes them; all others are sheets.
/// @throws InputError as read_floes() does, and where a sheet has a thickness or a strength, or there is no sheet.
GivenLevelIce read_level_ice(const std::string& path, const model::FieldSection& field);

/// Reads polygons that may overlap and lie anywhere, each simple.
/// @param origin  of the case in the file's coordinates [m].
/// @throws InputError naming file and place, as read_floes() does.
std::vector<geometry::Polygon> read_openings(const std::string& path, Vec2 origin);

/// Content of a file that these functions pass over, such as "heights (12)"; empty: none, or it cannot be read.
/// @param of_lines  whether it is a file of cracks.
/// @throws InputError when the file cannot be opened.
std::string left_out_of(const std::string& path, Vec2 origin, bool of_lines);

/// Reads the straight pieces of lines from WKT or GeoJSON. @throws InputError naming file and place.
std::vector<geometry::Crack> read_cracks(const std::string& path, Vec2 origin);

/// Reads outlines from such a file; they may lie anywhere. @throws InputError naming file and place.
std::vector<geometry::Polygon> read_outlines(const std::string& path, Vec2 origin);

}  // namespace brash::ice
