// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/formats/ledger.hpp"

#include <nlohmann/json.hpp>

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

}  // namespace brash::formats
