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
  if (const auto polygons = from_wkt(text_of(data, size))) {
    const auto again = from_wkt(to_wkt(*polygons));
    if (!again || *again != *polygons) std::abort();
    lay(*polygons);
  }
  if (const auto features = from_geojson(text_of(data, size))) {
    const auto again = from_geojson(to_geojson(*features));
    if (!again || *again != *features) std::abort();
    std::vector<Polygon> polygons;
    for (const Feature& feature : *features) polygons.push_back(feature.polygon);
    lay(polygons);
  }
  if (const auto map = read_map(text_of(data, size))) {
    const auto again = read_map(map_to_geojson(*map), map->origin);
    if (!again || again->features != map->features || again->crs != map->crs) std::abort();
  }
  return 0;
}
