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

bool IceSheet::contains(Vec2 point) const {
  const Point p = snap(point);
  return impl_->boundary.is_on_boundary(p) || impl_->boundary.is_inside(p);
}

std::vector<Polygon> IceSheet::polygons() const {
  const FreeEdges& boundary = impl_->boundary;
  std::map<int, std::vector<Ring>> parts;
  for (std::size_t k = 0; k < boundary.loops().size(); ++k) {
    const int loop = static_cast<int>(k);
    if (boundary.loops()[k].edge >= 0) parts[boundary.outline_of(loop)].push_back(boundary.ring_of(loop));
  }
  std::vector<Polygon> polygons;
  for (const auto& [outline, loops] : parts) polygons.push_back(polygon_of(loops));
  std::sort(polygons.begin(), polygons.end(), [](const Polygon& a, const Polygon& b) { return a.outline < b.outline; });
  return polygons;
}

std::vector<Polygon> IceSheet::release_detached() {
  FreeEdges& boundary = impl_->boundary;
  if (boundary.n_outlines() <= 1) return {};
  struct Part {
    int outline;
    Int128 twice_area;
    std::vector<int> loops;
  };
  std::map<int, Part> parts;
  for (std::size_t k = 0; k < boundary.loops().size(); ++k) {
    if (boundary.loops()[k].edge < 0) continue;
    const int outline = boundary.outline_of(static_cast<int>(k));
    Part& part = parts.try_emplace(outline, Part{outline, 0, {}}).first->second;
    part.twice_area += boundary.loops()[k].twice_area;
    part.loops.push_back(static_cast<int>(k));
  }
  // Of parts of equal area the first by name stays, so that the outcome is defined.
  const auto largest = std::max_element(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
    return a.second.twice_area < b.second.twice_area;
  });
  std::vector<Polygon> released;
  for (const auto& [outline, part] : parts) {
    if (outline == largest->first) continue;
    std::vector<Ring> loops;
    for (const int loop : part.loops) loops.push_back(boundary.take_loop(loop));
    released.push_back(polygon_of(loops));
  }
  std::sort(released.begin(), released.end(), [](const Polygon& a, const Polygon& b) { return a.outline < b.outline; });
  return released;
}

}  // namespace brash::geometry
