// SPDX-License-Identifier: GPL-3.0-or-later
#include "origin_text.hpp"

#include <vector>

#include "brash/io/origin.hpp"

namespace brash::cli {

void add_origin(const model::Origin& origin, nlohmann::ordered_json& table) {
  if (!origin.empty()) table["origin"] = origin;
}

std::string origin_text(const nlohmann::ordered_json& table, const std::string& before) {
  if (!table.contains("origin")) return "";
  const auto names = [&](const char* key) { return table["origin"][key].get<std::vector<std::string>>(); };
  return before + io::origin_line({names("presets"), names("programs")}) + "\n";
}

}  // namespace brash::cli
