// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer: any text is WKT, GeoJSON or an error. Polygons that were read stay the same when written and read again.
// A sheet made of them is whole, or refused.
#include <cstdlib>

#include "brash/geometry/text.hpp"
#include "scratch_file.hpp"

namespace {

using namespace brash::geometry;

void lay(const std::vector<Polygon>& polygons) {
  if (const auto sheet = IceSheet::from_polygons(polygons)) sheet->check();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (const auto map = read_polygons(text_of(data, size))) {
    const std::vector<Polygon> polygons = polygons_of(map->features);
    const auto wkt = read_polygons(to_wkt(polygons));
    if (!wkt || polygons_of(wkt->features) != polygons) std::abort();
    const auto json = read_polygons(to_geojson(map->features));
    if (!json || json->features != map->features) std::abort();
    lay(polygons);
  }
  if (const auto map = read_map(text_of(data, size))) {
    const auto again = read_map(map_to_geojson(*map), map->origin);
    if (!again || again->features != map->features || again->crs != map->crs) std::abort();
  }
  return 0;
}
