// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_file.hpp"

#include <filesystem>
#include <optional>

#include "brash/campaign/subprocess.hpp"
#include "brash/core/error.hpp"
#include "brash/core/write_file.hpp"
#include "brash/io/file_names.hpp"

namespace brash::cli {
namespace {

/// A PNG of the drawing in a file; nothing without rsvg-convert.
std::optional<campaign::Printed> converted(const std::string& drawing) {
  try {
    return campaign::run_command({"rsvg-convert", "--format=png", "--zoom=2", drawing});
  } catch (const RunError&) {
    return std::nullopt;
  }
}

}  // namespace

void check_picture_name(const std::string& path) { io::check_ending(path, "a picture", {".svg", ".png"}); }

void write_picture(const std::string& path, const std::string& svg) {
  if (!path.ends_with(".png")) return write_file(path, svg);
  const std::string drawing = part_of(path);
  write_file(drawing, svg);
  const auto png = converted(drawing);
  std::filesystem::remove(drawing);
  if (!png)
    throw InputError(Complaint{path, "rsvg-convert, which makes a PNG of a drawing, is not on the path",
                               "a name that ends in .svg, or .png with rsvg-convert",
                               "name an SVG file, or install Debian's package librsvg2-bin"});
  if (png->code != 0) throw RunError(path + ": rsvg-convert failed: " + png->err);
  write_file(path, png->out);
}

}  // namespace brash::cli
