// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace brash::cli {

/// Refuses a name of a picture that ends neither in .svg nor in .png; empty: none is drawn.
/// @throws InputError.
void check_picture_name(const std::string& path);

/// Writes a drawing: as PNG if the name ends in .png, else as the SVG that it is.
///
/// PNG is made by librsvg's program rsvg-convert, at two pixels for one of the drawing.
/// @throws InputError for a PNG without rsvg-convert on the path; StorageError as write_file.
void write_picture(const std::string& path, const std::string& svg);

}  // namespace brash::cli
