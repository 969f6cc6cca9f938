// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <nlohmann/json.hpp>

#include "brash/formats/maps.hpp"
#include "brash/geometry/repair.hpp"
#include "ledger.hpp"

namespace brash::formats {
namespace {

using geometry::Feature;
using geometry::Map;
using geometry::Repair;

std::string text_of(const Repair& repair, const Map& map) {
  nlohmann::ordered_json faults = nlohmann::ordered_json::array();
  for (const geometry::Fault& fault : repair.faults) faults.push_back(fault.what);
  return ledger_text({{"given", repair.given},
                      {"kept", repair.kept},
                      {"overlap", repair.overlap},
                      {"folded", repair.folded},
                      {"snap", repair.snap},
                      {"missing", repair.missing()}},
                     repair.closes(),
                     {{"n_changed", repair.changed.size()},
                      {"n_gone", repair.gone.size()},
                      {"n_polygons", map.features.size()},
                      {"changed", repair.changed},
                      {"faults", faults}},
                     map.origin);
}

}  // namespace

std::string repair_map(const std::string& path, Map& map) {
  const auto repair = geometry::repair(geometry::polygons_of(map.features));
  if (!repair) refuse_polygons(path, repair.error().what);
  std::int64_t next_id = 0;
  for (const Feature& feature : map.features) next_id = std::max(next_id, feature.id + 1);
  std::vector<Feature> features;
  for (const Repair::Part& part : repair->parts) {
    const bool is_first = &part == &repair->parts.front() || (&part - 1)->from != part.from;
    Feature& feature = features.emplace_back(map.features[part.from]);
    feature.polygon = part.polygon;
    if (!is_first) feature.id = next_id++;
  }
  map.features = std::move(features);
  return text_of(*repair, map);
}

}  // namespace brash::formats
