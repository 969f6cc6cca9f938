// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brash/geometry/polygon.hpp"
#include "brash/model/case.hpp"

namespace brash::ice {

/// A floe of a file.
struct GivenFloe {
  geometry::Polygon outline;
  std::optional<double> thickness;          ///< [m]; absent: of the case
  std::optional<double> flexural_strength;  ///< [Pa]; likewise
};

/// Reads floes from WKT or GeoJSON, told apart by the first character. The properties `thickness` and
/// `flexural_strength` of a GeoJSON feature are the ones of its floes.
///
/// @param field  whose rectangle holds every floe.
/// @throws InputError naming file and place when the text is at fault, floes overlap, a floe leaves the field, or a
///         property is out of range.
std::vector<GivenFloe> read_floes(const std::string& path, const model::FieldSection& field);

/// Reads outlines from such a file. @throws InputError likewise; they may lie anywhere.
std::vector<geometry::Polygon> read_outlines(const std::string& path);

}  // namespace brash::ice
