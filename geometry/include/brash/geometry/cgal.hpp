// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <sstream>
#include <string>
#include <tl/expected.hpp>
#include <utility>

#include "brash/geometry/ice_sheet.hpp"

// Polygons as CGAL's and back, for any kernel whose numbers hold doubles (EPICK, EPECK, Simple_cartesian<double>).
//
// This is the one public header that includes CGAL; a program that includes it links CGAL::CGAL as well.
namespace brash::geometry {

/// `ring` as a CGAL polygon in plan metres, vertex by vertex. Exact: doubles hold every grid point.
template <typename Kernel>
CGAL::Polygon_2<Kernel> to_cgal(std::span<const Point> ring) {
  CGAL::Polygon_2<Kernel> result;
  for (const Point p : ring) result.push_back(typename Kernel::Point_2(metres(p).x, metres(p).y));
  return result;
}

/// `polygon` as a CGAL polygon with holes in plan metres. Exact.
template <typename Kernel>
CGAL::Polygon_with_holes_2<Kernel> to_cgal(const Polygon& polygon) {
  CGAL::Polygon_with_holes_2<Kernel> result(to_cgal<Kernel>(polygon.outline));
  for (const Ring& hole : polygon.holes) result.add_hole(to_cgal<Kernel>(hole));
  return result;
}

/// Coordinates from CGAL that are no whole number of grid units.
enum class OffGrid {
  kRefuse,  ///< An error.
  kRound,   ///< To the nearest grid point, halves upwards; rounded rings may touch or cross themselves.
};

namespace detail {

/// The grid coordinate [grid units] of a CGAL number [m], or the error in it.
template <typename Number>
tl::expected<std::int64_t, std::string> grid_coordinate(const Number& value, OffGrid off_grid) {
  const double near = CGAL::to_double(value);
  if (!(std::abs(near) <= kMaxCoordinate)) return tl::unexpected<std::string>("lies beyond +-8192 m");
  // to_double may be off by a little: the exact value decides.
  std::int64_t units = std::llround(near / kGridUnit);
  const auto rest = [&] { return Number(value - Number(static_cast<double>(units) * kGridUnit)); };
  const Number half(0.5 * kGridUnit);
  while (rest() >= half) ++units;
  while (rest() < -half) --units;
  if (off_grid == OffGrid::kRefuse && rest() != Number(0)) {
    return tl::unexpected<std::string>("is not a multiple of 2^-30 m; OffGrid::kRound rounds it");
  }
  return units;
}

}  // namespace detail

/// The grid points of a CGAL polygon in plan metres, either way round, in its order.
/// @return the ring, or which vertex lies off the grid or beyond kMaxCoordinate, or that the ring has no area.
template <typename Kernel>
tl::expected<Ring, GeometryError> ring_from_cgal(const CGAL::Polygon_2<Kernel>& polygon,
                                                 OffGrid off_grid = OffGrid::kRefuse) {
  Ring ring;
  for (auto vertex = polygon.vertices_begin(); vertex != polygon.vertices_end(); ++vertex) {
    const auto x = detail::grid_coordinate(vertex->x(), off_grid);
    const auto y = detail::grid_coordinate(vertex->y(), off_grid);
    if (!x || !y) {
      std::ostringstream what;
      what.precision(17);
      what << "vertex " << ring.size() << ": (" << CGAL::to_double(vertex->x()) << ", " << CGAL::to_double(vertex->y())
           << ") " << (x ? y.error() : x.error());
      return tl::unexpected(GeometryError{what.str()});
    }
    ring.push_back(Point::of_units(*x, *y));
  }
  if (signed_area(ring) == ExactArea{}) return tl::unexpected(GeometryError{"the ring has no area"});
  return ring;
}

/// The polygon on the grid; outlines come out counter-clockwise and holes clockwise, whatever they were.
/// @return the polygon, or the error and the ring that has it. IceSheet::from_polygons checks that rings neither
///   cross nor overlap.
template <typename Kernel>
tl::expected<Polygon, GeometryError> polygon_from_cgal(const CGAL::Polygon_with_holes_2<Kernel>& polygon,
                                                       OffGrid off_grid = OffGrid::kRefuse) {
  if (polygon.is_unbounded()) return tl::unexpected(GeometryError{"the polygon is unbounded: it has no outline"});
  const auto oriented = [&](const CGAL::Polygon_2<Kernel>& from, bool is_hole) {
    auto ring = ring_from_cgal(from, off_grid);
    if (ring && (signed_area(*ring) < ExactArea{}) != is_hole) std::reverse(ring->begin() + 1, ring->end());
    return ring;
  };
  auto outline = oriented(polygon.outer_boundary(), false);
  if (!outline) return tl::unexpected(GeometryError{"the outline, " + outline.error().what});
  Polygon result{std::move(*outline), {}};
  for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole) {
    auto ring = oriented(*hole, true);
    if (!ring) {
      const std::string name = "hole " + std::to_string(result.holes.size());
      return tl::unexpected(GeometryError{name + ", " + ring.error().what});
    }
    result.holes.push_back(std::move(*ring));
  }
  return result;
}

}  // namespace brash::geometry
