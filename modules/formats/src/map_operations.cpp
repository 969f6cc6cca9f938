// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of a map, with a ledger of its area: cracks, repair and union.
#include <algorithm>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <utility>

#include "brash/formats/maps.hpp"
#include "brash/geometry/repair.hpp"
#include "brash/geometry/unite.hpp"

namespace brash::formats {
namespace {

using geometry::Feature;
using geometry::Map;
using geometry::Repair;
using geometry::Union;

/// A ledger of exact areas as JSON: the areas [m2] as decimal numbers in text, `closes`, the rest, and the origin of
/// the map, if it has one.
/// @param rest  what else was counted: an object.
std::string ledger_text(std::initializer_list<std::pair<const char*, geometry::ExactArea>> areas, bool closes,
                        const nlohmann::ordered_json& rest, const geometry::Origin& origin) {
  nlohmann::ordered_json json;
  for (const auto& [name, area] : areas) json[name] = area.to_string();
  json["closes"] = closes;
  json.update(rest);
  if (origin != geometry::Origin{}) json["origin"] = {origin.x.to_string(), origin.y.to_string()};
  return json.dump(2);
}

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

std::string ledger_text(const geometry::Ledger& ledger, std::size_t n_sheet_parts, std::size_t n_floes,
                        const geometry::Origin& origin) {
  return ledger_text({{"initial", ledger.initial},
                      {"sheet", ledger.sheet},
                      {"floes", ledger.floes},
                      {"crushed", ledger.crushed},
                      {"deleted", ledger.deleted},
                      {"brash", ledger.brash},
                      {"snap", ledger.snap},
                      {"missing", ledger.missing()}},
                     ledger.closes(),
                     {{"n_rounded", ledger.n_rounded}, {"n_sheet_parts", n_sheet_parts}, {"n_floes", n_floes}}, origin);
}

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
