// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/geometry/cgal.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/mpl/list.hpp>
#include <boost/test/unit_test.hpp>

#include "shapes.hpp"

namespace brash::geometry {
namespace {

using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Kernels = boost::mpl::list<Inexact, Exact>;

/// A ring of points anywhere on the grid, far out and near zero.
Polygon with_holes() {
  constexpr std::int64_t kFar = std::int64_t{8192} << 30;
  Polygon polygon{shapes::units({{-kFar, -kFar}, {kFar, 1 - kFar}, {kFar - 1, kFar}, {3, kFar}}), {}};
  polygon.holes.push_back(shapes::units({{-7, 1}, {-5, 12345678901}, {1, 0}, {0, -1}}));
  polygon.holes.push_back(shapes::units({{(1LL << 42) + 1, 0}, {1LL << 42, 5}, {(1LL << 42) + 2, 3}}));
  return polygon;
}

BOOST_AUTO_TEST_SUITE(polygons_of_cgal)

BOOST_AUTO_TEST_CASE_TEMPLATE(a_polygon_with_holes_comes_back_point_by_point, Kernel, Kernels) {
  const Polygon polygon = with_holes();
  const auto there = to_cgal<Kernel>(polygon);
  BOOST_TEST(there.number_of_holes() == 2u);
  const auto back = polygon_from_cgal(there);
  BOOST_TEST_REQUIRE(back.has_value(), (back ? "" : back.error().what));
  BOOST_TEST((*back == polygon));
}

BOOST_AUTO_TEST_CASE(areas_of_both_are_equal) {
  const Polygon polygon = with_holes();
  Exact::FT sum = to_cgal<Exact>(polygon).outer_boundary().area();
  for (const Ring& hole : polygon.holes) sum += to_cgal<Exact>(hole).area();
  // One double holds the top of twice the area in grid units, another the rest.
  const Int128 twice = area(polygon).twice_in_grid_units();
  const auto top = static_cast<double>(twice);
  const auto rest = static_cast<double>(twice - static_cast<Int128>(top));
  BOOST_TEST((sum == (Exact::FT(top) + Exact::FT(rest)) * kGridUnit * kGridUnit / 2));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(rings_come_in_either_way_round, Kernel, Kernels) {
  Polygon turned = with_holes();
  turned.outline = shapes::reversed(turned.outline);
  for (Ring& hole : turned.holes) hole = shapes::reversed(hole);
  BOOST_TEST((polygon_from_cgal(to_cgal<Kernel>(turned)).value() == with_holes()));
  BOOST_TEST((ring_from_cgal(to_cgal<Kernel>(turned.outline)).value() == turned.outline));
}

BOOST_AUTO_TEST_CASE(a_vertex_off_the_grid_is_refused_or_rounded_when_asked) {
  CGAL::Polygon_2<Exact> triangle;
  triangle.push_back({0, 0});
  triangle.push_back({1, 0});
  triangle.push_back({Exact::FT(1) / 3, 1});
  const auto refused = ring_from_cgal(triangle);
  BOOST_TEST_REQUIRE(!refused.has_value());
  BOOST_TEST(refused.error().what.find("vertex 2: (0.333333333") == 0u, refused.error().what);
  BOOST_TEST(refused.error().what.find("OffGrid::kRound") != std::string::npos);
  // 2^30 / 3 = 357913941.33
  BOOST_TEST((ring_from_cgal(triangle, OffGrid::kRound).value()[2] == Point::of_units(357913941, 1LL << 30)));
}

BOOST_AUTO_TEST_CASE(halves_round_upwards_however_close_to_one) {
  const Exact::FT half = Exact::FT(kGridUnit) / 2;
  const Exact::FT tiny = half / Exact::FT(1e30);
  const auto rounded = [](const Exact::FT& x) { return detail::grid_coordinate(x, OffGrid::kRound).value(); };
  BOOST_TEST(rounded(half) == 1);
  BOOST_TEST(rounded(half - tiny) == 0);
  BOOST_TEST(rounded(-half) == 0);
  BOOST_TEST(rounded(-half - tiny) == -1);
  // A value that doubles cannot tell from the grid is still off it.
  BOOST_TEST(!detail::grid_coordinate(Exact::FT(Exact::FT(5) + tiny), OffGrid::kRefuse).has_value());
}

BOOST_AUTO_TEST_CASE(what_is_no_polygon_on_the_grid_is_refused_with_its_place) {
  const auto refusal = [](const CGAL::Polygon_with_holes_2<Inexact>& polygon) {
    const auto result = polygon_from_cgal(polygon);
    BOOST_TEST_REQUIRE(!result.has_value());
    return result.error().what;
  };
  BOOST_TEST(refusal({}) == "the polygon is unbounded: it has no outline");
  CGAL::Polygon_2<Inexact> far;
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {9000.0, 0.0}, {0.0, 1.0}}) far.push_back({x, y});
  BOOST_TEST(refusal(CGAL::Polygon_with_holes_2<Inexact>(far)) ==
             "the outline, vertex 1: (9000, 0) lies beyond +-8192 m");
  auto holed = to_cgal<Inexact>(Polygon{shapes::box(0, 0, 4, 4), {}});
  CGAL::Polygon_2<Inexact> flat;
  for (const double x : {1.0, 2.0, 3.0}) flat.push_back({x, x});
  holed.add_hole(flat);
  BOOST_TEST(refusal(holed) == "hole 0, the ring has no area");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace brash::geometry
