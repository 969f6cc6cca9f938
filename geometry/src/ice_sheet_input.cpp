// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "brash/core/contract.hpp"
#include "brash/core/interruption.hpp"
#include "brash/geometry/lines.hpp"
#include "brash/geometry/repair.hpp"
#include "ice_sheet_impl.hpp"
#include "polygon_edges.hpp"

namespace brash::geometry {

namespace {

/// Faults, and places of one fault, that a message lists.
constexpr std::size_t kMostPlaces = 20;

using Pair = std::pair<std::size_t, std::size_t>;

/// The places where polygons cross themselves or each other.
std::map<Pair, std::set<Point>> places_of(const std::vector<PolygonEdges::Crossing>& crossings) {
  std::map<Pair, std::set<Point>> places;
  for (const auto& [first, second, at] : crossings) places[{first, second}].insert(at);
  return places;
}

Fault crossing(const Pair& pair, const std::set<Point>& places) {
  const auto& [first, second] = pair;
  std::string what =
      polygon_name(first) + (first == second ? " crosses itself" : " crosses " + polygon_name(second)) + " at ";
  std::size_t n = 0;
  for (const Point at : places) {
    if (n == kMostPlaces) break;
    what += (n++ > 0 ? ", " : "") + place(at);
  }
  if (places.size() > n) what += " and " + std::to_string(places.size() - n) + " more places";
  return {first, second, what};
}

/// The fault of the only polygon.
std::string fault_alone(const Polygon& polygon) {
  PolygonEdges edges;
  if (std::string fault = edges.add(polygon, 0); !fault.empty()) return fault;
  if (const auto places = places_of(edges.crossings()); !places.empty())
    return crossing({0, 0}, places.at({0, 0})).what;
  if (!edges.flat_ring().empty()) return edges.flat_ring();
  const PolygonEdges::Noded noded = edges.noded({});
  const auto boundary = boundary_of(noded.nodes, noded.edges);
  return boundary ? "" : std::string(boundary.error().what) + " at " + place(boundary.error().at);
}

/// The same with the number of the polygon among others.
std::string fault_alone(const Polygon& polygon, std::size_t i) {
  const std::string fault = fault_alone(polygon), name = polygon_name(0);
  if (fault.empty()) return fault;
  return polygon_name(i) + (fault.starts_with(name) ? fault.substr(name.size()) : ": " + fault);
}

/// Where two polygons that do not cross overlap.
std::optional<Point> overlap_of(const Polygon& one, const Polygon& other) {
  PolygonEdges edges;
  edges.add(one, 0);
  edges.add(other, 1);
  const PolygonEdges::Noded noded = edges.noded({});
  const auto boundary = boundary_of(noded.nodes, noded.edges);
  return boundary ? std::nullopt : std::optional(boundary.error().at);
}

/// Adds the pairs of sound polygons that overlap and do not cross.
void add_overlaps(std::span<const Polygon> polygons, const std::vector<char>& is_sound,
                  const std::map<Pair, std::set<Point>>& crossings, std::vector<Fault>& faults) {
  std::vector<std::pair<exact::Box, std::size_t>> boxes;
  for (std::size_t i = 0; i < polygons.size(); ++i)
    if (is_sound[i]) boxes.emplace_back(exact::box_of(polygons[i].outline), i);
  std::ranges::sort(boxes, {}, [](const auto& box) { return box.first.low; });
  std::map<Pair, Point> overlaps;
  for (auto a = boxes.begin(); a != boxes.end(); ++a)
    for (auto b = a + 1; b != boxes.end() && b->first.low.x < a->first.high.x; ++b) {
      const Pair pair = std::minmax(a->second, b->second);
      if (!a->first.overlaps(b->first) || crossings.contains(pair)) continue;
      look_for_interruption();
      if (const auto at = overlap_of(polygons[pair.first], polygons[pair.second])) overlaps.emplace(pair, *at);
    }
  for (const auto& [pair, at] : overlaps)
    faults.push_back({pair.first, pair.second,
                      polygon_name(pair.first) + " overlaps " + polygon_name(pair.second) + " at " + place(at)});
}

/// The boundary of polygons that are simple and disjoint; or where they overlap, or nothing of another fault.
tl::expected<FreeEdges::Change, std::optional<OverlapError>> sound_boundary(std::span<const Polygon> polygons) {
  const auto faulty = tl::unexpected(std::optional<OverlapError>());
  PolygonEdges edges;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    // A polygon with holes is checked alone: among others a hole may lie in one that is not its own.
    if (polygons.size() > 1 && !polygons[i].holes.empty() && !fault_alone(polygons[i]).empty()) return faulty;
    if (!edges.add(polygons[i], i).empty()) return faulty;
  }
  if (!edges.flat_ring().empty() || !edges.crossings().empty()) return faulty;
  const PolygonEdges::Noded noded = edges.noded({});
  auto boundary = boundary_of(noded.nodes, noded.edges);
  if (!boundary) return tl::unexpected(std::optional(boundary.error()));
  return *std::move(boundary);
}

/// The first and the last polygon with a vertex at a place.
Pair polygons_at(Point at, std::span<const Polygon> polygons) {
  std::optional<Pair> found;
  for (std::size_t i = 0; i < polygons.size(); ++i)
    visit_edges(polygons[i], [&](Point from, Point) {
      if (from == at) found = Pair{found ? found->first : i, i};
    });
  return found.value_or(Pair{});
}

}  // namespace

std::string text_of(std::span<const Fault> faults) {
  std::string text;
  for (std::size_t i = 0; i < std::min(faults.size(), kMostPlaces); ++i) text += (i > 0 ? "; " : "") + faults[i].what;
  return faults.size() > kMostPlaces ? text + "; and " + std::to_string(faults.size() - kMostPlaces) + " more" : text;
}

std::vector<Fault> own_faults_of(std::span<const Polygon> polygons) {
  std::vector<Fault> faults;
  for (std::size_t i = 0; i < polygons.size(); ++i)
    if (std::string fault = fault_alone(polygons[i], i); !fault.empty()) faults.push_back({i, i, std::move(fault)});
  return faults;
}

std::vector<Fault> faults_of(std::span<const Polygon> polygons) {
  const auto boundary = sound_boundary(polygons);
  if (boundary) return {};
  std::vector<Fault> faults = own_faults_of(polygons);
  std::vector<char> is_sound(polygons.size(), 1);
  for (const Fault& fault : faults) is_sound[fault.first] = 0;
  PolygonEdges edges;
  for (std::size_t i = 0; i < polygons.size(); ++i) edges.add(polygons[i], i);
  const auto crossings = places_of(edges.crossings());
  for (const auto& [pair, places] : crossings)
    if (pair.first != pair.second) faults.push_back(crossing(pair, places));
  add_overlaps(polygons, is_sound, crossings, faults);
  // Rounding lets polygons overlap that do not, pair by pair: an edge goes through a vertex of a third one.
  if (faults.empty() && boundary.error()) {
    const auto [first, last] = polygons_at(boundary.error()->at, polygons);
    faults.push_back({first, last, std::string(boundary.error()->what) + " at " + place(boundary.error()->at)});
  }
  return faults;
}

tl::expected<IceSheet, GeometryError> IceSheet::from_polygons(std::span<const Polygon> polygons) {
  const auto boundary = sound_boundary(polygons);
  if (!boundary) {
    const std::string fault = polygons.size() == 1 ? fault_alone(polygons.front()) : text_of(faults_of(polygons));
    return tl::unexpected(GeometryError{fault});
  }
  auto impl = std::make_unique<Impl>();
  impl->boundary.apply(*boundary);
  return IceSheet(std::move(impl));
}

void IceSheet::check() const {
  const FreeEdges& edges = impl_->boundary;
  edges.check_loops();
  edges.check_nodes();
  // Made again from its polygons the sheet is the same; that checks the sides and the nesting of loops.
  const std::vector<Polygon> before = polygons();
  const auto again = from_polygons(before);
  BRASH_EXPECTS(again.has_value(), again.error().what);
  BRASH_EXPECTS(again->area() == area() && again->n_vertices() == n_vertices() && again->polygons() == before,
                again->n_vertices(), n_vertices(), area().to_string());
}

}  // namespace brash::geometry
