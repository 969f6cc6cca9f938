// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "brash/formats/replay.hpp"
#include "brash/geometry/ledger.hpp"
#include "brash/geometry/text.hpp"
#include "brash/io/file_names.hpp"

namespace brash::formats {

/// The largest text of a map that is read [MiB]. Parsed polygons take some twenty times the memory of their text; this
/// much text holds a million vertices.
inline constexpr std::size_t kMostMebibytes = 64;

/// A map of a WKT or GeoJSON file, at most 64 MiB.
///
/// @param origin  as of geometry::read_map(): without one it is the file's own, zero, or the middle of the data.
/// @throws InputError naming file, line and column.
geometry::Map read_map_file(const std::string& path, const std::optional<geometry::Origin>& origin);

/// Refuses a file with the place and the fault in it.
[[noreturn]] void refuse_polygons(const std::string& where, const std::string& what);

/// Throws InputError unless the name of a map to write goes with a format: .wkt is WKT; .geojson, .json and a name
/// without an ending are GeoJSON.
void check_map_name(const std::string& path);

/// A map as text in the format of the name of its file. WKT has one polygon a line.
std::string to_map_text(const std::string& path, const geometry::Map& map);

/// Whether the format of a file cannot hold all that a map knows: WKT has no kinds of polygons, ids and coordinate
/// reference system.
bool loses_knowledge(const std::string& path, const geometry::Map& map);

/// Gives a map the coordinate reference system that the user names, if it has no other one.
/// @param name  such as EPSG:32633.
/// @throws InputError for another kind of name, for a system of degrees, and for a system that is not the map's.
void take_crs(geometry::Map& map, const std::string& name);

/// The ice of a run from above: level ice and floes, in the coordinates of the map that the case came from.
///
/// Floes keep their outlines: one that is tilted is laid flat where it is. So floes may overlap.
/// @param time  of the frame at it, or of the last one before it [s].
/// @throws InputError when the run has no frame at or before `time`.
geometry::Map ice_map(const Replay& run, double time);

/// The ledger of cuts, the number of parts of the sheet and of floes, and the origin, as JSON.
std::string ledger_text(const geometry::Ledger& ledger, std::size_t n_sheet_parts, std::size_t n_floes,
                        const geometry::Origin& origin);

/// Unites the polygons of a map, the polygons of each kind with one another. Ice of floes goes; `notes` hears so.
/// @param path  of the map, for messages.
/// @return the ledger of the areas as JSON.
/// @throws InputError naming a polygon that is not simple.
std::string unite_map(const std::string& path, geometry::Map& map, const io::Notes& notes = {});

/// Removes crossings and overlaps of the polygons of a map, whatever their kinds (geometry::repair()). The parts of a
/// polygon keep its kind and its ice; all but the first get new ids.
/// @param path  of the map, for messages.
/// @return what was changed, and the ledger of the areas, as JSON.
/// @throws InputError when a fault remains.
std::string repair_map(const std::string& path, geometry::Map& map);

}  // namespace brash::formats
