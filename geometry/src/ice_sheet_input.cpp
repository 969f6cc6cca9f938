// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <set>

#include "brash/core/contract.hpp"
#include "ice_sheet_impl.hpp"
#include "polygon_edges.hpp"

namespace brash::geometry {

namespace {

/// Places that a message lists.
constexpr std::size_t kMostPlaces = 20;

/// All crossings in words, those of one pair of polygons together; empty: there is none.
std::string text_of(const std::vector<PolygonEdges::Crossing>& crossings) {
  std::map<std::pair<std::size_t, std::size_t>, std::set<Point>> places;
  std::size_t n = 0;
  for (const auto& [first, second, at] : crossings) n += places[{first, second}].insert(at).second ? 1 : 0;
  std::string text;
  std::size_t n_told = 0;
  for (const auto& [pair, at] : places) {
    if (n_told == kMostPlaces) break;
    text += (text.empty() ? "" : "; ") + polygon_name(pair.first) +
            (pair.first == pair.second ? " crosses itself" : " crosses " + polygon_name(pair.second));
    for (const Point p : at) {
      if (n_told == kMostPlaces) break;
      text += (p == *at.begin() ? " at " : ", ") + place(p);
      ++n_told;
    }
  }
  return n > n_told ? text + "; and " + std::to_string(n - n_told) + " more" : text;
}

/// The fault of the polygon with the number `i`, or nothing.
std::string fault_alone(const Polygon& polygon, std::size_t i) {
  const auto alone = IceSheet::from_polygons(std::span(&polygon, 1));
  if (alone) return {};
  const std::string &fault = alone.error().what, name = polygon_name(0);
  return polygon_name(i) + (fault.starts_with(name) ? fault.substr(name.size()) : ": " + fault);
}

}  // namespace

tl::expected<IceSheet, GeometryError> IceSheet::from_polygons(std::span<const Polygon> polygons) {
  PolygonEdges edges;
  std::string fault;
  // Each polygon with holes is checked alone: among others a hole may lie in one that is not its own.
  for (std::size_t i = 0; i < polygons.size() && polygons.size() > 1 && fault.empty(); ++i)
    if (!polygons[i].holes.empty()) fault = fault_alone(polygons[i], i);
  for (std::size_t i = 0; i < polygons.size() && fault.empty(); ++i) fault = edges.add(polygons[i], i);
  if (fault.empty()) fault = text_of(edges.crossings());
  if (!fault.empty()) return tl::unexpected(GeometryError{fault});

  const PolygonEdges::Noded noded = edges.noded({});
  const auto change = boundary_of(noded.nodes, noded.edges);
  if (!change)
    return tl::unexpected(GeometryError{std::string(change.error().what) + " at " + place(change.error().at)});
  auto impl = std::make_unique<Impl>();
  impl->boundary.apply(*change);
  return IceSheet(std::move(impl));
}

void IceSheet::check() const {
  const FreeEdges& edges = impl_->boundary;
  edges.check_loops();
  edges.check_nodes();
  // Made again from its polygons the sheet is the same; that judges the sides and the nesting of loops.
  const std::vector<Polygon> before = polygons();
  const auto again = from_polygons(before);
  BRASH_EXPECTS(again.has_value(), again.error().what);
  BRASH_EXPECTS(again->area() == area() && again->n_vertices() == n_vertices() && again->polygons() == before,
                again->n_vertices(), n_vertices(), area().to_string());
}

}  // namespace brash::geometry
