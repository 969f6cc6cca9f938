// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "brash/geometry/text.hpp"

namespace brash::cli {

/// The value of --origin; nothing where the option is not given.
/// @throws InputError naming `command` for anything but X,Y.
std::optional<geometry::Origin> origin_option(const std::string& command, const std::string& value);

/// As formats::read_map_file(); says on stderr which content of the file was left out.
geometry::Map read_map_file(const std::string& path, const std::optional<geometry::Origin>& origin);

/// Says on stderr which content of a file was left out, if any.
void say_left_out(const std::string& path, const std::string& left_out);

/// Says on stderr which origin a map got from its data, and whether its coordinates could be degrees.
void say_place(const std::string& path, const geometry::Map& map, bool origin_is_given);

/// Writes a map in the format of its name, and says on stderr which knowledge WKT drops.
void write_map_file(const std::string& path, const geometry::Map& map);

/// Refuses a name of a picture that ends neither in .svg nor in .png; empty: none is drawn.
/// @throws InputError.
void check_picture_name(const std::string& path);

/// Writes a drawing: as PNG if the name ends in .png, else as the SVG that it is.
///
/// PNG is made by librsvg's program rsvg-convert, at two pixels for one of the drawing.
/// @throws InputError for a PNG without rsvg-convert on the path; StorageError as write_file.
void write_picture(const std::string& path, const std::string& svg);

}  // namespace brash::cli
