// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/geometry/area.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

#include "brash/core/contract.hpp"
#include "brash/geometry/point.hpp"

namespace brash::geometry {
namespace {

constexpr Int128 kTwoPerSquareMetre = Int128{1} << 61;

BOOST_AUTO_TEST_SUITE(areas)

BOOST_AUTO_TEST_CASE(snap_takes_the_nearest_grid_point_and_halves_away_from_zero) {
  BOOST_TEST((snap({0.0, 1.0}) == Point::of_units(0, 1LL << 30)));
  BOOST_TEST((snap({0.5 * kGridUnit, -0.5 * kGridUnit}) == Point::of_units(1, -1)));
  BOOST_TEST((snap({0.4999999 * kGridUnit, -1.5 * kGridUnit}) == Point::of_units(0, -2)));
  BOOST_TEST((snap({kMaxCoordinate, -kMaxCoordinate}) == Point::of_units(1LL << 43, -(1LL << 43))));
}

BOOST_AUTO_TEST_CASE(a_grid_point_survives_the_way_to_metres_and_back) {
  for (const Point p : {Point::of_units(1, -1), Point::of_units((1LL << 43) - 1, -(1LL << 43) + 1),
                        Point::of_units(123456789012345 % (1LL << 43), 7)})
    BOOST_TEST((snap(metres(p)) == p));
}

BOOST_AUTO_TEST_CASE(snap_refuses_what_the_grid_does_not_hold) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const Vec2 bad : {Vec2{kNaN, 0}, Vec2{0, kNaN}, Vec2{kInfinity, 0}, Vec2{0, -8193.0}})
    BOOST_CHECK_THROW(snap(bad), ContractViolation);
}

BOOST_AUTO_TEST_CASE(the_text_of_an_area_is_exact) {
  BOOST_TEST(ExactArea(0).to_string() == "0");
  BOOST_TEST(ExactArea(kTwoPerSquareMetre).to_string() == "1");
  BOOST_TEST(ExactArea(-kTwoPerSquareMetre / 2).to_string() == "-0.5");
  BOOST_TEST(ExactArea(2500 * kTwoPerSquareMetre + kTwoPerSquareMetre / 8).to_string() == "2500.125");
  // 2^-61 and 2^-60, from bc.
  BOOST_TEST(ExactArea(1).to_string() == "0.0000000000000000004336808689942017736029811203479766845703125");
  BOOST_TEST(ExactArea(-2).to_string() == "-0.000000000000000000867361737988403547205962240695953369140625");
  // The most negative number has no positive twin: -2^127 / 2^61 = -2^66.
  BOOST_TEST(ExactArea(Int128{1} << 126).to_string() == "36893488147419103232");
  BOOST_TEST(ExactArea(-(Int128{1} << 126) - (Int128{1} << 126)).to_string() == "-73786976294838206464");
}

BOOST_AUTO_TEST_CASE(square_metres_is_the_nearest_double) {
  constexpr Int128 kUlp = Int128{1} << (61 - 52);  // of 1 m2
  BOOST_TEST(ExactArea(kTwoPerSquareMetre).square_metres() == 1.0);
  BOOST_TEST(ExactArea(kTwoPerSquareMetre + kUlp).square_metres() == 1.0 + 0x1p-52);
  BOOST_TEST(ExactArea(kTwoPerSquareMetre + kUlp / 2).square_metres() == 1.0);  // a tie goes to the even neighbour
  BOOST_TEST(ExactArea(kTwoPerSquareMetre + kUlp / 2 + 1).square_metres() == 1.0 + 0x1p-52);
  BOOST_TEST(ExactArea(kTwoPerSquareMetre + 3 * kUlp / 2).square_metres() == 1.0 + 0x1p-51);
  BOOST_TEST(ExactArea(1).square_metres() == 0x1p-61);
  BOOST_TEST(ExactArea(-3).square_metres() == -0x1.8p-60);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace brash::geometry
