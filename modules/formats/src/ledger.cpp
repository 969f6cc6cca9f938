// SPDX-License-Identifier: GPL-3.0-or-later
#include "ledger.hpp"

#include <nlohmann/json.hpp>

#include "brash/formats/maps.hpp"

namespace brash::formats {

std::string ledger_text(std::initializer_list<std::pair<const char*, geometry::ExactArea>> areas, bool closes,
                        const nlohmann::ordered_json& rest, const geometry::Origin& origin) {
  nlohmann::ordered_json json;
  for (const auto& [name, area] : areas) json[name] = area.to_string();
  json["closes"] = closes;
  json.update(rest);
  if (origin != geometry::Origin{}) json["origin"] = {origin.x.to_string(), origin.y.to_string()};
  return json.dump(2);
}

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

}  // namespace brash::formats
