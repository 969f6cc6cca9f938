// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <nlohmann/json.hpp>

#include "brash/formats/maps.hpp"
#include "brash/geometry/repair.hpp"

namespace brash::formats {
namespace {

using geometry::Feature;
using geometry::Map;
using geometry::Repair;

std::string ledger_text(const Repair& repair, const Map& map) {
  nlohmann::ordered_json json;
  const auto put = [&](const char* name, geometry::ExactArea area) { json[name] = area.to_string(); };
  put("given", repair.given);
  put("kept", repair.kept);
  put("overlap", repair.overlap);
  put("folded", repair.folded);
  put("snap", repair.snap);
  put("missing", repair.missing());
  json["closes"] = repair.closes();
  json["n_changed"] = repair.changed.size();
  json["n_gone"] = repair.gone.size();
  json["n_polygons"] = map.features.size();
  json["changed"] = repair.changed;
  json["faults"] = nlohmann::ordered_json::array();
  for (const geometry::Fault& fault : repair.faults) json["faults"].push_back(fault.what);
  if (map.origin != geometry::Origin{}) json["origin"] = {map.origin.x.to_string(), map.origin.y.to_string()};
  return json.dump(2);
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
  return ledger_text(*repair, map);
}

}  // namespace brash::formats
