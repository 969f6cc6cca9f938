// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "text_ring.hpp"

namespace brash::geometry {

/// True when the name of a coordinate reference system, such as "urn:ogc:def:crs:EPSG::4326", stands for longitudes and
/// latitudes. Knows OGC's CRS84, CRS83 and CRS27 and the usual codes of EPSG; no registry is asked.
bool is_geographic(std::string_view name);

/// Why degrees are refused, with the remedy.
std::string degrees_refused(std::string_view name);

/// Whether all positions could be longitudes and latitudes of places with sea ice, beyond 40 degrees.
bool could_be_degrees(const Survey& survey);

/// The JSON object of `text` that begins at `offset`, as it is written.
std::string_view object_at(std::string_view text, std::size_t offset);

}  // namespace brash::geometry
