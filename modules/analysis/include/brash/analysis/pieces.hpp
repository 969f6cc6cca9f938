// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "brash/geometry/polygon.hpp"
#include "brash/io/file_names.hpp"
#include "brash/model/origin.hpp"
#include "brash/statistics/sizes.hpp"

namespace brash::analysis {

/// Sizes of the pieces of a map or a run.
struct PieceSizes {
  std::string source;             ///< for people: "floes of map.geojson"
  std::vector<double> diameters;  ///< mean caliper [m]
  std::vector<double> areas;      ///< [m2], in the same order
  std::size_t n_left_out = 0;     ///< sheet parts of a map, floes of a run that are gone
  model::Origin origin{};         ///< of the run; empty for a map
};

/// The pieces of a file.
///
/// @param path  a run's folder or run.nc: floes alive at the end; else a map (WKT or GeoJSON): its floes, or where it
///              names none, all its polygons.
/// @param born  of a run: every floe that was ever born, also those that are gone.
/// @param notes hears which content of a map was left out.
/// @throws InputError for a file that is not a run or a map, or without pieces.
PieceSizes read_piece_sizes(const std::string& path, bool born, const io::Notes& notes = {});
/// The sizes of polygons.
/// @throws InputError for a polygon without area, or one that is not simple on its own.
PieceSizes piece_sizes_of(const std::vector<geometry::Polygon>& polygons, const std::string& source);

/// Size distribution with its fits; docs/theory/ice.md.
struct PieceAnalysis {
  std::vector<statistics::SizeFit> fits;
  std::vector<std::string> not_fitted;  ///< "Weibull: why"
};
PieceAnalysis analyse_pieces(const PieceSizes& sizes);

/// Everything as JSON: quantiles by number and by area, moments, fits with intervals and their tests.
nlohmann::ordered_json pieces_json(const PieceSizes& sizes, const PieceAnalysis& analysis);
/// The same as a table for people.
std::string pieces_text(const nlohmann::ordered_json& json);

}  // namespace brash::analysis
