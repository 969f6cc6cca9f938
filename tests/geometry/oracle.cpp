// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle.hpp"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <list>

#include "brash/geometry/cgal.hpp"

namespace brash::geometry::oracle {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using CgalPolygon = CGAL::Polygon_with_holes_2<Kernel>;

std::vector<CgalPolygon> to_cgal(const std::vector<Polygon>& polygons) {
  std::vector<CgalPolygon> result;
  for (const Polygon& polygon : polygons) result.push_back(to_cgal<Kernel>(polygon));
  return result;
}

Kernel::FT area_of(const CgalPolygon& polygon) {
  Kernel::FT area = polygon.outer_boundary().area();
  for (const auto& hole : polygon.holes()) area += hole.area();
  return area;
}

template <typename Polygons>
Kernel::FT area_of(const Polygons& polygons) {
  Kernel::FT area = 0;
  for (const CgalPolygon& polygon : polygons) area += area_of(polygon);
  return area;
}

/// The ice outside the region.
std::vector<CgalPolygon> difference(const std::vector<CgalPolygon>& ice, const CgalPolygon& region) {
  std::vector<CgalPolygon> result;
  for (const CgalPolygon& polygon : ice) {
    CGAL::difference(polygon, region, std::back_inserter(result), CGAL::Tag_false());
  }
  return result;
}

/// Area that lies in exactly one of two sets of disjoint polygons [m2].
double mismatch(const std::vector<CgalPolygon>& a, const std::vector<CgalPolygon>& b) {
  Kernel::FT common = 0;
  for (const CgalPolygon& p : a) {
    for (const CgalPolygon& q : b) {
      if (!CGAL::do_overlap(p.bbox(), q.bbox())) continue;
      std::list<CgalPolygon> both;
      CGAL::intersection(p, q, std::back_inserter(both), CGAL::Tag_false());
      common += area_of(both);
    }
  }
  return CGAL::to_double(area_of(a) + area_of(b) - 2 * common);
}

double perimeter(const Ring& ring) {
  double length = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) length += norm(metres(ring[(i + 1) % ring.size()]) - metres(ring[i]));
  return length;
}

}  // namespace

Deviation deviation(const std::vector<Polygon>& before, const Ring& region, const IceSheet& sheet, const Cut& cut) {
  const std::vector<CgalPolygon> ice = to_cgal(before);
  const CgalPolygon cutter(to_cgal<Kernel>(region));
  Deviation result;
  result.sheet = mismatch(difference(ice, cutter), to_cgal(sheet.polygons()));
  std::vector<CgalPolygon> taken;
  for (const CgalPolygon& polygon : ice) {
    CGAL::intersection(polygon, cutter, std::back_inserter(taken), CGAL::Tag_false());
  }
  result.pieces = mismatch(taken, to_cgal(cut.pieces));
  // Leading an edge through the pixels it meets moves it by less than one grid unit, the new edges as well as the old.
  double length = perimeter(region);
  for (const Polygon& polygon : before) {
    length += perimeter(polygon.outline);
    for (const Ring& hole : polygon.holes) length += perimeter(hole);
  }
  result.allowed = length * kGridUnit;
  return result;
}

double area_outside(const std::vector<Polygon>& ice, const Ring& region) {
  return CGAL::to_double(area_of(difference(to_cgal(ice), CgalPolygon(to_cgal<Kernel>(region)))));
}

bool are_disjoint(const std::vector<Polygon>& polygons) {
  const std::vector<CgalPolygon> parts = to_cgal(polygons);
  std::vector<CgalPolygon> joined;
  CGAL::join(parts.begin(), parts.end(), std::back_inserter(joined), CGAL::Tag_false());
  return area_of(joined) == area_of(parts);
}

}  // namespace brash::geometry::oracle
