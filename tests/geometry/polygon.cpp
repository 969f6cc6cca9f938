// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/geometry/polygon.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "brash/geometry/caliper.hpp"

namespace brash::geometry {
namespace {

Ring box(double x0, double y0, double x1, double y1) {
  return ring(std::vector<Vec2>{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
}

Ring reversed(Ring r) { return {r.rbegin(), r.rend()}; }

// Braces would take metres for grid units; snap() and Point::of_units() are the ways to a point.
static_assert(!std::is_aggregate_v<Point>);
static_assert(!std::is_constructible_v<Point, int, int> && !std::is_constructible_v<Point, double, double>);
static_assert(!std::is_constructible_v<Point, Vec2> && !std::is_convertible_v<Vec2, Point>);

BOOST_AUTO_TEST_SUITE(polygons)

BOOST_AUTO_TEST_CASE(the_mean_caliper_diameter_is_the_perimeter_of_the_hull_over_pi) {
  BOOST_TEST(mean_caliper_diameter(box(0, 0, 3, 4)) == 14.0 / kPi, boost::test_tools::tolerance(1e-15));
  // A bay and a vertex on the hull's edge change nothing.
  const Ring bay = ring(std::vector<Vec2>{{0, 0}, {1.5, 0}, {3, 0}, {3, 4}, {1.5, 1}, {0, 4}});
  BOOST_TEST(mean_caliper_diameter(bay) == 14.0 / kPi, boost::test_tools::tolerance(1e-15));
  // A polygon in a circle of radius 5 with 1000 sides: short by the factor sinc(pi/1000).
  const double factor = std::sin(kPi / 1000) / (kPi / 1000);
  BOOST_TEST(mean_caliper_diameter(disc({1, 2}, 5, 1000)) == 10.0 * factor, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(areas_are_exact_and_signed) {
  const Ring square = box(-1.0, -1.0, 1.0, 1.0);
  BOOST_TEST(signed_area(square).to_string() == "4");
  BOOST_TEST(signed_area(reversed(square)).to_string() == "-4");
  // One grid unit more on one corner: twice the area grows by exactly one diagonal's worth of units.
  Ring moved = square;
  moved[2].x += 1;
  BOOST_TEST(
      (signed_area(moved).twice_in_grid_units() - signed_area(square).twice_in_grid_units() == (Int128{1} << 31)));
}

BOOST_AUTO_TEST_CASE(the_largest_coordinates_do_not_overflow) {
  const Ring everything = box(-kMaxCoordinate, -kMaxCoordinate, kMaxCoordinate, kMaxCoordinate);
  BOOST_TEST(signed_area(everything).to_string() == "268435456");  // (2^14)^2
}

BOOST_AUTO_TEST_CASE(holes_are_taken_off) {
  const Polygon plate{box(0, 0, 4, 2), {reversed(box(1, 0.5, 2, 1.5))}};
  BOOST_TEST(area(plate).to_string() == "7");
  // (8 * (2,1) - 1 * (1.5,1)) / 7; a few roundings of numbers of order 10.
  BOOST_TEST(centroid(plate).x == 14.5 / 7.0, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(centroid(plate).y == 1.0, boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(the_centroid_of_a_sliver_far_from_the_origin_lies_on_it) {
  const Ring sliver{snap({8000, 8000}), snap({8001, 8000}),
                    Point::of_units(snap({8000, 8000}).x, snap({8000, 8000}).y + 1)};
  const Vec2 c = centroid({sliver, {}});
  BOOST_TEST(c.x == 8000.0 + 1.0 / 3.0, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(std::abs(c.y - 8000.0) <= 1e-9);  // the sliver is one grid unit, 0.93e-9 m, thick
}

BOOST_AUTO_TEST_CASE(a_polygon_without_area_has_no_centroid) {
  const Polygon line{{Point{}, Point::of_units(1, 1), Point::of_units(2, 2)}, {}};
  BOOST_CHECK_THROW(centroid(line), ContractViolation);
}

BOOST_AUTO_TEST_CASE(convexity_is_decided_exactly) {
  Ring square = box(0, 0, 1, 1);
  BOOST_TEST(is_convex(square));
  BOOST_TEST(!is_convex(reversed(square)));
  square.insert(square.begin() + 1, snap({0.5, 0.0}));
  BOOST_TEST(is_convex(square));  // straight on is not a turn
  square[1].y += 1;
  BOOST_TEST(!is_convex(square));
}

BOOST_AUTO_TEST_CASE(a_disc_lies_on_its_circle_and_is_short_of_it_by_the_stated_area) {
  for (const int sides : {3, 8, 16, 64}) {
    const Ring circle = disc({10.0, -3.0}, 2.5, sides, 0.3);
    BOOST_TEST(circle.size() == static_cast<std::size_t>(sides));
    BOOST_TEST(is_convex(circle));
    for (const Point p : circle) BOOST_TEST(std::abs(norm(metres(p) - Vec2{10.0, -3.0}) - 2.5) < kGridUnit);
    const double expected = kPi * 2.5 * 2.5 * std::sin(2 * kPi / sides) / (2 * kPi / sides);
    // Each vertex is off by at most 0.71 grid units: relative 2 * 0.66e-9 / 2.5.
    BOOST_TEST(signed_area(circle).square_metres() == expected, boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_CASE(a_ring_is_counter_clockwise_and_without_repeated_neighbours) {
  const std::vector<Vec2> clockwise{{0, 0}, {0, 1}, {1e-12, 1}, {1, 1}, {1, 0}, {0, 0}};
  const Ring r = ring(clockwise);
  BOOST_TEST((r == Ring{snap({0, 0}), snap({1, 0}), snap({1, 1}), snap({0, 1})}));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace brash::geometry
