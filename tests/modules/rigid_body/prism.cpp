// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>

#include "brash/core/contract.hpp"
#include "helpers.hpp"

using namespace brash;
using namespace brash::rigid_body;
using namespace brash::rigid_body::testing;

// Sums of products of numbers of order one to a hundred: a few ulp.
constexpr double kRoundOff = 1e-12;

BOOST_AUTO_TEST_CASE(A_box_has_the_mass_and_inertia_of_a_box) {
  const std::vector<std::vector<Vec2>> ring{rectangle({10, 20}, {14, 22})};
  const PlacedPrism placed = place_prism(ring, ring, 0.5, -0.1);
  BOOST_TEST(placed.pose.position.x == 12.0, boost::test_tools::tolerance(kRoundOff));
  BOOST_TEST(placed.pose.position.y == 21.0, boost::test_tools::tolerance(kRoundOff));
  BOOST_TEST(placed.pose.position.z == -0.1);
  const MassProperties m = mass_properties(placed.prism, 900.0, 0.5);
  const double mass = 1.5 * 900.0 * 4 * 2 * 0.5;
  BOOST_TEST(m.mass == mass, boost::test_tools::tolerance(kRoundOff));
  BOOST_TEST(m.inertia.x == mass * (2 * 2 + 0.25) / 12, boost::test_tools::tolerance(kRoundOff));
  BOOST_TEST(m.inertia.y == mass * (4 * 4 + 0.25) / 12, boost::test_tools::tolerance(kRoundOff));
  BOOST_TEST(m.inertia.z == mass * (4 * 4 + 2 * 2) / 12, boost::test_tools::tolerance(kRoundOff));
}

BOOST_AUTO_TEST_CASE(The_long_axis_of_a_turned_rectangle_is_the_body_s_x_axis) {
  const double angle = radians(35);
  std::vector<Vec2> ring = rectangle({-3, -1}, {3, 1});
  for (Vec2& p : ring)
    p = {7 + std::cos(angle) * p.x - std::sin(angle) * p.y, -4 + std::sin(angle) * p.x + std::cos(angle) * p.y};
  const std::vector<std::vector<Vec2>> rings{ring};
  const PlacedPrism placed = place_prism(rings, rings, 0.3, 0.0);
  BOOST_TEST(2 * std::atan2(placed.pose.rotation.z, placed.pose.rotation.w) == angle,
             boost::test_tools::tolerance(kRoundOff));
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 body = placed.prism.rings[0][i];
    const Vec3 back = to_world(placed.pose, {body.x, body.y, 0.0});
    BOOST_TEST(norm(plan(back) - ring[i]) < 1e-14 * 10);  // ulp of a coordinate of 10 m
  }
}

BOOST_AUTO_TEST_CASE(A_square_keeps_the_axes_of_the_sheet) {
  const std::vector<std::vector<Vec2>> ring{rectangle({31.7, 8.3}, {33.7, 10.3})};
  BOOST_TEST(place_prism(ring, ring, 0.3, 0.0).pose.rotation.z == 0.0);
}

BOOST_AUTO_TEST_CASE(A_hole_takes_its_mass_and_inertia_away) {
  std::vector<Vec2> hole = rectangle({-1, -0.5}, {1, 0.5});
  std::reverse(hole.begin(), hole.end());
  const std::vector<std::vector<Vec2>> rings{rectangle({-2, -1}, {2, 1}), hole};
  const PlacedPrism placed = place_prism(rings, {}, 0.4, 0.0);
  const MassProperties m = mass_properties(placed.prism, 1000.0, 0.0);
  BOOST_TEST(m.mass == 1000 * 0.4 * (8 - 2), boost::test_tools::tolerance(kRoundOff));
  BOOST_TEST(m.inertia.z == 400.0 * (8 * 20 - 2 * 5) / 12, boost::test_tools::tolerance(kRoundOff));
}

BOOST_AUTO_TEST_CASE(A_clockwise_outline_is_a_broken_contract) {
  std::vector<Vec2> ring = rectangle({0, 0}, {1, 1});
  std::reverse(ring.begin(), ring.end());
  const std::vector<std::vector<Vec2>> rings{ring};
  BOOST_CHECK_THROW(place_prism(rings, rings, 0.3, 0.0), ContractViolation);
}
