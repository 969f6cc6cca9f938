// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <nlohmann/json.hpp>

#include "brash/formats/maps.hpp"
#include "brash/geometry/repair.hpp"
#include "brash/geometry/unite.hpp"
#include "ledger.hpp"

namespace brash::formats {
namespace {

using geometry::Feature;
using geometry::Map;
using geometry::Union;

/// The union of all features of a kind, whose polygons have been checked.
Union united(const Map& map, const std::string& kind) {
  std::vector<Feature> features;
  std::ranges::copy_if(map.features, std::back_inserter(features), [&](const Feature& f) { return f.kind == kind; });
  return geometry::unite(geometry::polygons_of(features)).value();
}

void add(const Union& part, Union& sum) {
  sum.given += part.given;
  sum.united += part.united;
  sum.overlap += part.overlap;
  sum.snap += part.snap;
  sum.n_rounded += part.n_rounded;
}

std::string text_of(const Union& sum, const Map& map) {
  return ledger_text({{"given", sum.given},
                      {"united", sum.united},
                      {"overlap", sum.overlap},
                      {"snap", sum.snap},
                      {"missing", sum.missing()}},
                     sum.closes(), {{"n_rounded", sum.n_rounded}, {"n_polygons", map.features.size()}}, map.origin);
}

}  // namespace

std::string unite_map(const std::string& path, Map& map, const io::Notes& notes) {
  if (const auto faults = geometry::own_faults_of(geometry::polygons_of(map.features)); !faults.empty())
    refuse_polygons(path, geometry::text_of(faults) + " (polygons count from 0)");
  const auto has_own_ice = [](const Feature& f) { return f.thickness || f.flexural_strength; };
  if (notes && std::ranges::any_of(map.features, has_own_ice))
    notes(path + ": left out: thickness and flexural_strength, since a union may join floes of different ice");
  Union sum;
  std::vector<Feature> features;
  for (const std::string kind : {"sheet", "floe"}) {
    const Union part = united(map, kind);
    add(part, sum);
    for (const geometry::Polygon& polygon : part.polygons)
      features.push_back({polygon, kind, static_cast<std::int64_t>(features.size())});
  }
  map.features = std::move(features);
  return text_of(sum, map);
}

}  // namespace brash::formats
