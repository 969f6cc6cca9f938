// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brash/geometry/text.hpp"

namespace brash::cli {

/// The value of --origin; nothing where the option is not given.
/// @throws InputError naming `command` for anything but X,Y.
std::optional<geometry::Origin> origin_option(const std::string& command, const std::string& value);

/// The GeoJSON member `crs` for a name such as EPSG:32633.
/// @throws InputError for another name, and for a system of degrees.
std::string crs_member(const std::string& name);

/// A map of a WKT or GeoJSON file, at most 64 MiB.
///
/// @param origin  as of geometry::read_map(): without one it is the file's own, zero, or the middle of the data.
/// @throws InputError naming file, line and column.
geometry::Map read_map_file(const std::string& path, const std::optional<geometry::Origin>& origin);

/// Says on stderr which content of a file was left out, if any.
void say_left_out(const std::string& path, const std::string& left_out);

/// Says on stderr which origin a map got from its data, and whether its coordinates could be degrees.
void say_place(const std::string& path, const geometry::Map& map, bool origin_is_given);

/// Throws InputError unless the name of a map to write goes with a format: .wkt is WKT; .geojson, .json and a name
/// without an ending are GeoJSON.
void check_map_name(const std::string& path);
/// Writes a map in the format of its name. WKT has one polygon a line, and says on stderr which knowledge it drops.
void write_map_file(const std::string& path, const geometry::Map& map);

/// Refuses a file with the place and the fault in it.
[[noreturn]] void refuse_polygons(const std::string& where, const std::string& what);

/// The largest text that is read [MiB]. Parsed polygons take some twenty times the memory of their text; this much text
/// holds a million vertices.
inline constexpr std::size_t kMostMebibytes = 64;

}  // namespace brash::cli
