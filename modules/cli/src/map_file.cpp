// SPDX-License-Identifier: GPL-3.0-or-later
#include "map_file.hpp"

#include <fmt/format.h>

#include "brash/core/error.hpp"
#include "brash/core/text.hpp"
#include "brash/core/write_file.hpp"
#include "brash/formats/maps.hpp"
#include "messages.hpp"

namespace brash::cli {

using geometry::Map;
using geometry::Origin;

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
        "such "
        "a file first (ogr2ogr -t_srs EPSG:CODE), or give --origin 0,0 if they are metres\n",
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

}  // namespace brash::cli
