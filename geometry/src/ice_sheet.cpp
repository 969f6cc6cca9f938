// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/geometry/ice_sheet.hpp"

#include <algorithm>
#include <map>

#include "brash/core/contract.hpp"
#include "ice_sheet_impl.hpp"

namespace brash::geometry {

IceSheet::IceSheet(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
IceSheet::IceSheet(IceSheet&&) noexcept = default;
IceSheet& IceSheet::operator=(IceSheet&&) noexcept = default;
IceSheet::~IceSheet() = default;

ExactArea IceSheet::area() const { return ExactArea(impl_->boundary.twice_area()); }
std::size_t IceSheet::n_vertices() const { return impl_->boundary.n_edges(); }
std::size_t IceSheet::n_parts() const { return impl_->boundary.n_outlines(); }

bool IceSheet::contains(Vec2 point) const {
  const Point p = snap(point);
  return impl_->boundary.is_on_boundary(p) || impl_->boundary.is_inside(p);
}

namespace {

/// The loops of each connected part, by the loop of its outline.
std::map<int, std::vector<int>> parts_of(const FreeEdges& boundary) {
  std::map<int, std::vector<int>> parts;
  for (std::size_t k = 0; k < boundary.loops().size(); ++k) {
    const int loop = static_cast<int>(k);
    if (boundary.loops()[k].edge >= 0) parts[boundary.outline_of(loop)].push_back(loop);
  }
  return parts;
}

Polygon polygon_of(const FreeEdges& boundary, const std::vector<int>& part) {
  std::vector<Ring> loops;
  for (const int loop : part) loops.push_back(boundary.ring_of(loop));
  return polygon_of(loops);
}

Polygon take(FreeEdges& boundary, const std::vector<int>& part) {
  std::vector<Ring> loops;
  for (const int loop : part) loops.push_back(boundary.take_loop(loop));
  return polygon_of(loops);
}

void sort_by_outline(std::vector<Polygon>& polygons) {
  std::sort(polygons.begin(), polygons.end(), [](const Polygon& a, const Polygon& b) { return a.outline < b.outline; });
}

std::vector<Polygon> polygons_within(const FreeEdges& boundary) {
  std::vector<Polygon> polygons;
  for (const auto& [outline, part] : parts_of(boundary)) polygons.push_back(polygon_of(boundary, part));
  sort_by_outline(polygons);
  return polygons;
}

}  // namespace

std::vector<Polygon> IceSheet::polygons() const { return polygons_within(impl_->boundary); }

std::vector<Polygon> polygons_of(const FreeEdges::Change& boundary) {
  FreeEdges edges;
  edges.apply(boundary);
  return polygons_within(edges);
}

std::vector<Polygon> IceSheet::release_detached() {
  FreeEdges& boundary = impl_->boundary;
  if (boundary.n_outlines() <= 1) return {};
  const std::map<int, std::vector<int>> parts = parts_of(boundary);
  const auto twice_area = [&](const std::vector<int>& part) {
    Int128 sum = 0;
    for (const int loop : part) sum += boundary.loops()[loop].twice_area;
    return sum;
  };
  // Of parts of equal area the first by name stays, so that the outcome is defined.
  const auto largest = std::max_element(parts.begin(), parts.end(), [&](const auto& a, const auto& b) {
    return twice_area(a.second) < twice_area(b.second);
  });
  std::vector<Polygon> released;
  for (const auto& [outline, part] : parts) {
    if (outline != largest->first) released.push_back(take(boundary, part));
  }
  sort_by_outline(released);
  return released;
}

std::vector<Polygon> IceSheet::release_if(const std::function<bool(const Polygon&)>& is_loose) {
  FreeEdges& boundary = impl_->boundary;
  if (boundary.n_outlines() <= 1) return {};
  std::vector<Polygon> released;
  for (const auto& [outline, part] : parts_of(boundary)) {
    if (is_loose(polygon_of(boundary, part))) released.push_back(take(boundary, part));
  }
  sort_by_outline(released);
  return released;
}

}  // namespace brash::geometry
