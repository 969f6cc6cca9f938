// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>

#include "brash/core/contract.hpp"
#include "ice_sheet_impl.hpp"

namespace brash::geometry {

void expect_region(std::span<const Point> ring) {
  constexpr auto kMost = static_cast<std::int64_t>(kMaxCoordinate / kGridUnit);
  BRASH_EXPECTS(ring.size() >= 3, ring.size());
  for (const Point p : ring) BRASH_EXPECTS(std::abs(p.x) <= kMost && std::abs(p.y) <= kMost, p.x, p.y);
  BRASH_EXPECTS(signed_area(ring) > ExactArea{}, signed_area(ring).square_metres());
}

Polygon polygon_of(const Arrangement::Piece& piece) {
  std::vector<Ring> boundary;
  boundary.reserve(1 + piece.holes.size());
  const auto add = [&](const Arrangement::Walk& walk) {
    Ring& ring = boundary.emplace_back();
    ring.reserve(walk.size());
    for (const Arrangement::Side& side : walk) ring.push_back(side.from);
  };
  add(piece.outline);
  for (const Arrangement::Walk& hole : piece.holes) add(hole);
  return polygon_of(boundary);
}

namespace {

std::vector<Polygon> polygons_of(const std::vector<Arrangement::Piece>& pieces) {
  std::vector<Polygon> polygons;
  polygons.reserve(pieces.size());
  for (const Arrangement::Piece& piece : pieces) polygons.push_back(polygon_of(piece));
  std::sort(polygons.begin(), polygons.end(), [](const Polygon& a, const Polygon& b) { return a.outline < b.outline; });
  return polygons;
}

Extent extent_of(const FreeEdges& boundary, const FreeEdges::Change& change) {
  Extent extent;
  const auto add = [&](Point from, Point to) {
    extent.add(metres(from));
    extent.add(metres(to));
  };
  for (const int id : change.removed) add(boundary.edge(id).from, boundary.edge(id).to);
  for (const FreeEdges::Directed& edge : change.added) add(edge.from, edge.to);
  return extent;
}

/// A cut, and the vertices of the edges that it made.
struct Taken {
  Cut cut;
  std::vector<Point> vertices;
};

Taken take(FreeEdges& boundary, std::span<const Point> region, std::span<const Crack> cracks) {
  expect_region(region);
  std::optional<Noding> noding;
  std::optional<Arrangement> arrangement;
  Arrangement::Cracks inside{cracks_inside(region, cracks)};
  // Cracks that split nothing leave no trace, not even a vertex: where there is one, arrange again without them.
  do {
    noding.emplace(boundary, region, inside.splitting);
    arrangement.emplace(*noding, boundary);
    inside = arrangement->drop_useless_cracks();
  } while (inside.has_traces);
  Cut cut;
  cut.pieces = polygons_of(arrangement->pieces());
  cut.snap = ExactArea(-noding->twice_moved());
  cut.n_rounded = noding->n_rounded();

  // The area that leaves must equal the area that arrives. Both sides are counted: the sheet from its edges, snap from
  // the re-routed ones.
  const SheetChange sheet = arrangement->sheet_change();
  ExactArea balance = ExactArea(sheet.twice_area) + cut.snap;
  for (const Polygon& piece : cut.pieces) balance += geometry::area(piece);
  BRASH_EXPECTS(balance == ExactArea{}, balance.to_string(), cut.snap.to_string(), cut.pieces.size());
  cut.changed = extent_of(boundary, sheet.change);
  boundary.apply(sheet.change);
  Taken taken{std::move(cut), {}};
  for (const FreeEdges::Directed& edge : sheet.change.added) {
    taken.vertices.push_back(edge.from);
    taken.vertices.push_back(edge.to);
  }
  return taken;
}

}  // namespace

Cut IceSheet::cut(std::span<const Point> region, std::span<const Crack> cracks) {
  return take(impl_->boundary, region, cracks).cut;
}

Cut IceSheet::crush(std::span<const Point> region) {
  FreeEdges& boundary = impl_->boundary;
  auto [cut, vertices] = take(boundary, region, {});
  for (const Point vertex : vertices) {
    const Int128 before = boundary.twice_area();
    const auto edge = boundary.straighten(vertex);
    if (!edge || boundary.twice_area() == before) continue;
    cut.snap += ExactArea(before - boundary.twice_area());
    ++cut.n_rounded;
    cut.changed.add(metres(edge->from));
    cut.changed.add(metres(edge->to));
  }
  return cut;
}

std::vector<Polygon> IceSheet::within(std::span<const Point> window) const {
  expect_region(window);
  const Noding noding(impl_->boundary, window, {});
  return polygons_of(Arrangement::overlap(noding, impl_->boundary));
}

}  // namespace brash::geometry
