// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/geometry/unite.hpp"

#include <cstdlib>

#include "brash/core/contract.hpp"
#include "brash/geometry/lines.hpp"
#include "brash/geometry/text.hpp"
#include "ice_sheet_impl.hpp"
#include "polygon_edges.hpp"

namespace brash::geometry {
namespace {

/// Twice the area that faults of rounding may cover beside an edge: four units of the grid to its length.
Int128 most_round_off(const Polygon& polygon) {
  constexpr int kTwiceWidth = 2 * 4;
  Int128 sum = 0;
  visit_edges(polygon, [&](Point from, Point to) { sum += std::abs(to.x - from.x) + std::abs(to.y - from.y); });
  return kTwiceWidth * sum;
}

}  // namespace

tl::expected<Union, GeometryError> unite(std::span<const Polygon> polygons) {
  Union result;
  PolygonEdges edges;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    if (const std::string fault = fault_of(polygons[i]); !fault.empty())
      return tl::unexpected(GeometryError{polygon_name(i) + ": " + fault});
    edges.add(polygons[i], i);
    result.given += area(polygons[i]);
  }
  const std::vector<PolygonEdges::Crossing> crossings = edges.crossings();
  const PolygonEdges::Noded noded = edges.noded(crossings);
  const Coverage coverage = coverage_of(noded.nodes, noded.edges);
  for (const auto& [times, twice_area] : coverage.twice_areas) {
    BRASH_EXPECTS(times > 0, times);
    result.united += ExactArea(twice_area);
    result.overlap += ExactArea((times - 1) * twice_area);
  }
  result.snap -= ExactArea(noded.twice_moved);
  result.n_rounded = static_cast<std::int64_t>(crossings.size());
  result.polygons = polygons_of(coverage.boundary);
  BRASH_EXPECTS(result.closes(), result.missing().to_string());
  return result;
}

std::optional<Repaired> without_round_off(const Polygon& polygon) {
  PolygonEdges edges;
  if (!edges.add(polygon, 0).empty()) return std::nullopt;
  const PolygonEdges::Noded noded = edges.noded(edges.crossings());
  const Coverage coverage = coverage_of(noded.nodes, noded.edges);
  Int128 wrong = 0;
  for (const auto& [times, twice_area] : coverage.twice_areas)
    if (times != 1) wrong += twice_area;
  if (wrong > most_round_off(polygon)) return std::nullopt;
  return Repaired{polygons_of(coverage.boundary), ExactArea(wrong)};
}

}  // namespace brash::geometry
