// SPDX-License-Identifier: GPL-3.0-or-later
#include "files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "brash/campaign/subprocess.hpp"
#include "brash/core/error.hpp"
#include "brash/core/text.hpp"
#include "brash/core/write_file.hpp"
#include "brash/formats/maps.hpp"
#include "brash/io/file_names.hpp"
#include "messages.hpp"

namespace brash::cli {
namespace {

using geometry::Map;
using geometry::Origin;

/// A PNG of the drawing in a file; nothing without rsvg-convert.
std::optional<campaign::Printed> converted(const std::string& drawing) {
  try {
    return campaign::run_command({"rsvg-convert", "--format=png", "--zoom=2", drawing});
  } catch (const RunError&) {
    return std::nullopt;
  }
}

}  // namespace

std::optional<Origin> origin_option(const std::string& command, const std::string& value) {
  if (value.empty()) return std::nullopt;
  const auto origin = geometry::origin_from_text(value);
  if (!origin) {
    throw InputError(Complaint{command, fmt::format("--origin = '{}' is not a place", printable(value)),
                               "X,Y in the coordinates of the file, such as 500000,7000000", "change the option"});
  }
  return origin;
}

Map read_map_file(const std::string& path, const std::optional<Origin>& origin) {
  Map map = formats::read_map_file(path, origin);
  say_left_out(path, map.left_out);
  return map;
}

void say_left_out(const std::string& path, const std::string& left_out) {
  if (!left_out.empty()) say("note: {}: left out: {}\n", path, left_out);
}

void say_place(const std::string& path, const Map& map, bool origin_is_given) {
  if (map.looks_like_degrees) {
    say("warning: degrees: {}: all coordinates could be longitudes and latitudes. They are read as metres. Project "
        "such a file first (ogr2ogr -t_srs EPSG:CODE), or give --origin 0,0 if they are metres\n",
        path);
  }
  if (!origin_is_given && map.origin != Origin{}) say("{}: the origin is {}\n", path, to_string(map.origin));
}

void write_map_file(const std::string& path, const Map& map) {
  write_file(path, formats::to_map_text(path, map));
  if (formats::loses_knowledge(path, map))
    say("{}: WKT has no kinds, ids and coordinate reference system; every polygon is read back as sheet. GeoJSON keeps "
        "them\n",
        path);
}

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
