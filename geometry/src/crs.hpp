// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "text_ring.hpp"

namespace brash::geometry {

/// Why degrees are refused, with the remedy.
std::string degrees_refused(std::string_view name);

/// Whether all positions could be longitudes and latitudes of places with sea ice, beyond 40 degrees.
bool could_be_degrees(const Survey& survey);

/// The JSON object of `text` that begins at `offset`, as it is written.
std::string_view object_at(std::string_view text, std::size_t offset);

}  // namespace brash::geometry
