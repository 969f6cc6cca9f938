// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "brash/geometry/ice_sheet.hpp"
#include "brash/geometry/polygon.hpp"

namespace brash::python {

/// One polygon from whatever represents one: a Polygon, vertices with shape (n, 2), WKT or GeoJSON as text, or an
/// object with __geo_interface__ (shapely's). Simple, the outline counter-clockwise and holes clockwise afterwards.
/// @throws InputError naming the argument `name`.
geometry::Polygon to_polygon(pybind11::handle value, const char* name);

/// Several polygons: a sequence of such values, or one value, which may then be a multi-polygon.
std::vector<geometry::Polygon> to_polygons(pybind11::handle value, const char* name);

/// Straight cracks from whatever represents lines: vertices with shape (n, 2), WKT or GeoJSON as text, an object with
/// __geo_interface__, a sequence of such values, or ends of cracks with shape (n, 2, 2). Lines reach as far beyond
/// their free ends as those of `brash crack --along` (geometry::beyond_free_ends()); cracks given by their ends do not.
/// @throws InputError naming the argument `name`.
std::vector<geometry::Crack> to_cracks(pybind11::handle value, const char* name);

/// Warns of content that was left out, such as "heights (12)".
void warn_of_left_out(const std::string& name, const std::string& left_out);

/// A polygon without holes.
geometry::Ring to_ring(pybind11::handle value, const char* name);

}  // namespace brash::python
