// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>

#include "brash/geometry/area.hpp"
#include "brash/geometry/origin.hpp"

namespace brash::formats {

/// A ledger of exact areas as JSON: the areas [m2] as decimal numbers in text, `closes`, the rest, and the origin of
/// the map, if it has one.
/// @param rest  what else was counted: an object.
std::string ledger_text(std::initializer_list<std::pair<const char*, geometry::ExactArea>> areas, bool closes,
                        const nlohmann::ordered_json& rest, const geometry::Origin& origin);

}  // namespace brash::formats
