// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace brash::model {

/// The laws and the programs that numbers come from, each once. A run has one of both, a campaign may have several.
struct Origin {
  std::vector<std::string> presets;   ///< "brash", or "paper (2 keys changed)"
  std::vector<std::string> programs;  ///< "brash 0.2.0"

  bool empty() const { return presets.empty() && programs.empty(); }
  bool operator==(const Origin&) const = default;
};

/// Adds to `all` the names that it lacks.
inline void add(Origin& all, const Origin& more) {
  const auto add_names = [](std::vector<std::string>& names, const std::vector<std::string>& others) {
    for (const std::string& name : others)
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  add_names(all.presets, more.presets);
  add_names(all.programs, more.programs);
}

/// As JSON: {"presets": [...], "programs": [...]}.
template <typename Json>
void to_json(Json& json, const Origin& origin) {
  json["presets"] = origin.presets;
  json["programs"] = origin.programs;
}

}  // namespace brash::model
