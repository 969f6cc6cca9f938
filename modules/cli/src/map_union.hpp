// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "brash/geometry/text.hpp"

namespace brash::cli {

/// Unites the polygons of a map, those of each kind with one another. Ice of floes goes; stderr says so.
/// @param path  of the map, for messages.
/// @return the ledger of the areas as JSON.
/// @throws InputError naming a polygon that is not simple.
std::string unite_map(const std::string& path, geometry::Map& map);

}  // namespace brash::cli
