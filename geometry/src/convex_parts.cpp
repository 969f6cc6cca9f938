// SPDX-License-Identifier: GPL-3.0-or-later
// Convex parts by CGAL's Partition_2. All tests are exact signs, and every part's vertices are vertices of the polygon.
// CGAL's check of its result takes a fifth of the time; `is_valid` checks as much, from the way the parts are made.
// CGAL 6 has no macro for the checks of Partition_2 alone.
#define CGAL_NO_POSTCONDITIONS
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Partition_traits_2.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/partition_2.h>

#include <algorithm>
#include <array>
#include <list>

#include "brash/core/contract.hpp"
#include "brash/geometry/polygon.hpp"
#include "exact.hpp"

namespace brash::geometry {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Partition = CGAL::Partition_traits_2<Kernel>;

/// A triangulation whose vertices and faces know the simple ring that they went into last; 0: none yet.
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<int, Kernel>>;
using Triangles = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>, FaceBase>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;

/// Rings of up to so many vertices get the fewest parts; the time for that grows with the fourth power of the vertices.
constexpr std::size_t kMostForFewest = 32;

Kernel::Point_2 exactly(Point p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }
Point on_grid(const Kernel::Point_2& p) {
  return Point::of_units(static_cast<std::int64_t>(p.x()), static_cast<std::int64_t>(p.y()));
}

std::vector<Kernel::Point_2> exactly(const Ring& ring) {
  std::vector<Kernel::Point_2> points;
  points.reserve(ring.size());
  for (const Point p : ring) points.push_back(exactly(p));
  return points;
}

/// CGAL's concepts OptimalConvexPartitionTraits_2 and PolygonTraits_2 on grid points: 128 bits hold every sign, also
/// those that are exactly zero and slow with a filter.
struct Grid {
  using Point_2 = Point;
  struct Polygon_2 : Ring {};
  struct Equal_2 {
    bool operator()(Point p, Point q) const { return p == q; }
  };
  struct Less_xy_2 {
    bool operator()(Point p, Point q) const { return p < q; }
  };
  struct Compare_x_2 {
    CGAL::Comparison_result operator()(Point p, Point q) const { return CGAL::compare(p.x, q.x); }
  };
  struct Compare_y_2 {
    CGAL::Comparison_result operator()(Point p, Point q) const { return CGAL::compare(p.y, q.y); }
  };
  struct Orientation_2 {
    CGAL::Orientation operator()(Point p, Point q, Point r) const {
      const Int128 twice = turn(p, q, r);
      return twice > 0 ? CGAL::LEFT_TURN : twice < 0 ? CGAL::RIGHT_TURN : CGAL::COLLINEAR;
    }
  };
  struct Left_turn_2 {
    bool operator()(Point p, Point q, Point r) const { return turn(p, q, r) > 0; }
  };
  struct Collinear_are_ordered_along_line_2 {
    bool operator()(Point p, Point q, Point r) const { return p <= r ? p <= q && q <= r : r <= q && q <= p; }
  };
  struct Are_strictly_ordered_along_line_2 {
    bool operator()(Point p, Point q, Point r) const {
      return turn(p, q, r) == 0 && (p < r ? p < q && q < r : r < q && q < p);
    }
  };
  Equal_2 equal_2_object() const { return {}; }
  Less_xy_2 less_xy_2_object() const { return {}; }
  Compare_x_2 compare_x_2_object() const { return {}; }
  Compare_y_2 compare_y_2_object() const { return {}; }
  Orientation_2 orientation_2_object() const { return {}; }
  Left_turn_2 left_turn_2_object() const { return {}; }
  Collinear_are_ordered_along_line_2 collinear_are_ordered_along_line_2_object() const { return {}; }
  Are_strictly_ordered_along_line_2 are_strictly_ordered_along_line_2_object() const { return {}; }
};

/// Diagonals have cut the parts out of a simple ring, so the parts tile it if each is convex.
bool is_valid(const std::vector<Grid::Polygon_2>& parts) {
  return std::all_of(parts.begin(), parts.end(), [](const Ring& part) {
    return signed_area(part) > ExactArea{} && CGAL::is_convex_2(part.begin(), part.end(), Grid{});
  });
}

std::vector<Grid::Polygon_2> fewest_parts(const Ring& ring) {
  std::vector<Grid::Polygon_2> parts;
  CGAL::optimal_convex_partition_2(ring.begin(), ring.end(), std::back_inserter(parts), Grid{});
  return parts;
}

std::vector<Grid::Polygon_2> few_parts(const Ring& ring) {
  const std::vector<Kernel::Point_2> points = exactly(ring);
  std::list<Partition::Polygon_2> polygons;
  CGAL::approx_convex_partition_2(points.begin(), points.end(), std::back_inserter(polygons));
  std::vector<Grid::Polygon_2> parts;
  for (const Partition::Polygon_2& polygon : polygons) {
    Ring& part = parts.emplace_back();
    for (const Kernel::Point_2& p : polygon.container()) part.push_back(on_grid(p));
  }
  return parts;
}

/// Greene's partition into the fewest parts for small rings, Hertel and Mehlhorn's for large ones and for the few with
/// many vertices in line on which Greene's, as implemented, leaves a part that is not convex.
std::vector<Grid::Polygon_2> partition(const Ring& ring) {
  if (ring.size() <= kMostForFewest) {
    std::vector<Grid::Polygon_2> parts = fewest_parts(ring);
    if (is_valid(parts)) return parts;
  }
  std::vector<Grid::Polygon_2> parts = few_parts(ring);
  BRASH_EXPECTS(is_valid(parts), ring.size(), parts.size());
  return parts;
}

/// Appends the convex parts of a simple ring.
void append_parts(const Ring& ring, std::vector<Ring>& parts) {
  if (is_convex(ring)) {
    parts.push_back(ring);
    return;
  }
  for (Grid::Polygon_2& part : partition(ring)) parts.push_back(std::move(part));
}

/// A side of a ring that grows: its first vertex, and the edge of the triangle behind it.
struct GrowingSide {
  Triangles::Vertex_handle from;
  Triangles::Face_handle face;
  int edge;
};

/// Joins triangles inside the polygon to a ring, as long as each brings a new vertex: so the ring stays simple.
Ring grown_from(Triangles::Face_handle first, int number) {
  std::vector<GrowingSide> sides;
  first->info() = number;
  for (int i = 0; i < 3; ++i) {
    first->vertex(i)->info() = number;
    sides.push_back({first->vertex(i), first, Triangles::cw(i)});
  }
  for (std::size_t i = 0; i < sides.size();) {
    const auto [from, face, edge] = sides[i];
    const Triangles::Face_handle across = face->neighbor(edge);
    const Triangles::Vertex_handle to = face->vertex(Triangles::cw(edge));
    const int tip = 3 - across->index(from) - across->index(to);
    const Triangles::Vertex_handle fresh = across->vertex(tip);
    if (across->info() != 0 || fresh->info() == number) {
      ++i;
      continue;
    }
    across->info() = fresh->info() = number;
    sides[i] = {from, across, across->index(to)};
    sides.insert(sides.begin() + static_cast<std::ptrdiff_t>(i) + 1, {fresh, across, across->index(from)});
  }
  Ring ring;
  for (const GrowingSide& side : sides) ring.push_back(on_grid(side.from->point()));
  return ring;
}

/// The triangles by their vertices, so that the plan alone decides their order.
std::vector<Triangles::Face_handle> sorted_faces(const Triangles& triangles) {
  std::vector<std::pair<std::array<Point, 3>, Triangles::Face_handle>> faces;
  for (const Triangles::Face_handle face : triangles.finite_face_handles()) {
    std::array<Point, 3>& vertices = faces.emplace_back(std::array<Point, 3>{}, face).first;
    for (int i = 0; i < 3; ++i) vertices[i] = on_grid(face->vertex(i)->point());
    std::sort(vertices.begin(), vertices.end());
  }
  std::sort(faces.begin(), faces.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Triangles::Face_handle> sorted;
  for (const auto& [vertices, face] : faces) sorted.push_back(face);
  return sorted;
}

/// The polygon as simple rings: where it has holes, or touches itself, it is opened along diagonals.
std::vector<Ring> simple_rings(const Polygon& polygon) {
  constexpr int kOutside = -1;
  std::vector<Ring> boundary = polygon.holes;
  boundary.push_back(polygon.outline);
  Triangles triangles;
  for (const Ring& ring : boundary) {
    const std::vector<Kernel::Point_2> points = exactly(ring);
    triangles.insert_constraint(points.begin(), points.end(), true);
  }
  for (const Triangles::Vertex_handle vertex : triangles.finite_vertex_handles()) vertex->info() = 0;
  for (const Triangles::Face_handle face : triangles.all_face_handles()) face->info() = kOutside;
  for (const Triangles::Face_handle face : triangles.finite_face_handles()) {
    Point thrice{};
    for (int i = 0; i < 3; ++i) {
      thrice = thrice + on_grid(face->vertex(i)->point());
    }
    int turns = 0;
    for (const Ring& ring : boundary) turns += exact::winding(ring, thrice, 3);
    BRASH_EXPECTS(turns == 0 || turns == 1, "the polygon is not valid", turns, metres(thrice).x / 3.0);
    if (turns == 1) face->info() = 0;
  }
  std::vector<Ring> rings;
  for (const Triangles::Face_handle face : sorted_faces(triangles)) {
    if (face->info() == 0) rings.push_back(grown_from(face, static_cast<int>(rings.size()) + 1));
  }
  return rings;
}

}  // namespace

std::vector<Ring> convex_parts(const Polygon& polygon) {
  std::vector<Ring> parts;
  const Ring& outline = polygon.outline;
  if (polygon.holes.empty() && (is_convex(outline) || CGAL::is_simple_2(outline.begin(), outline.end(), Grid{}))) {
    append_parts(outline, parts);
  } else {
    try {
      for (const Ring& ring : simple_rings(polygon)) append_parts(ring, parts);
    } catch (const Triangles::Intersection_of_constraints_exception&) {
      BRASH_EXPECTS(false, "the polygon crosses itself", metres(outline[0]).x, metres(outline[0]).y);
    }
  }
  ExactArea sum;
  for (const Ring& part : parts) sum += signed_area(part);
  BRASH_EXPECTS(sum == area(polygon), sum.to_string(), area(polygon).to_string());
  return parts;
}

}  // namespace brash::geometry
