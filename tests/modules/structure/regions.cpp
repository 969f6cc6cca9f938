// SPDX-License-Identifier: GPL-3.0-or-later
// The regions of a hull that has them: docs/theory/structures.md, (K7).
#include "brash/structure/regions.hpp"

#include <boost/test/unit_test.hpp>

#include "meshes.hpp"

namespace {

using namespace brash;
using namespace brash::structure;
using model::HullRegion;

model::HullSection icebreaker() {
  model::HullSection hull;
  hull.length = 90.0;
  hull.breadth = 20.0;
  hull.draught = 7.0;
  hull.stem_angle = radians(22.0);
  hull.waterline_angle = radians(30.0);
  hull.midbody = 30.0;
  return hull;
}

BOOST_AUTO_TEST_SUITE(regions)

BOOST_AUTO_TEST_CASE(the_bow_ends_where_the_waterline_makes_ten_degrees_and_the_shoulders_abaft_its_full_breadth) {
  const HullRegions regions(*make_hull(model::Ship{icebreaker()}));
  // The bow's waterline is the parabola y = 10 (1 - (1 - t)^2), x = 45 - 34.64 t: its angle is tan(30 deg) (1 - t).
  const double bow = 20.0 / std::tan(radians(30.0));
  const double at_ten_degrees = 45.0 - bow * (1.0 - std::tan(radians(10.0)) / std::tan(radians(30.0)));
  BOOST_TEST(std::abs(regions.bow_end() - at_ten_degrees) <= bow / 24.0);  // a chord of the waterline
  BOOST_TEST(regions.shoulders_end() == 45.0 - bow - 0.04 * 90.0, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(regions.stern_start() == 45.0 - bow - 30.0, boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(a_place_has_the_region_of_its_length_and_the_bottom_is_what_lies_flat) {
  const HullRegions regions(*make_hull(model::Ship{icebreaker()}));
  const Vec3 aside{0.0, 1.0, 0.0}, down{0.0, 0.0, -1.0};
  BOOST_TEST((regions.at({40.0, 5.0, 0.0}, aside) == HullRegion::kBow));
  BOOST_TEST((regions.at({12.0, 10.0, 0.0}, aside) == HullRegion::kShoulders));
  BOOST_TEST((regions.at({0.0, -10.0, 0.0}, aside) == HullRegion::kSides));
  BOOST_TEST((regions.at({-30.0, -9.0, 0.0}, aside) == HullRegion::kStern));
  BOOST_TEST((regions.at({0.0, 0.0, -7.0}, down) == HullRegion::kBottom));
  BOOST_TEST(
      (regions.at({0.0, 0.0, -7.0}, {0.0, std::sin(radians(6.9)), -std::cos(radians(6.9))}) == HullRegion::kBottom));
  // A stem of 22 degrees lies flatter than many a bottom, and is bow.
  BOOST_TEST(
      (regions.at({40.0, 0.0, -1.0}, {std::sin(radians(22.0)), 0.0, -std::cos(radians(22.0))}) == HullRegion::kBow));
}

BOOST_AUTO_TEST_CASE(a_box_is_all_bow_at_its_front_and_a_cone_has_no_regions) {
  const HullRegions box(test::hull(test::box({-10.0, -3.0, -2.0}, {10.0, 3.0, 2.0})));
  BOOST_TEST((box.at({10.0, 0.0, 0.0}, {1.0, 0.0, 0.0}) == HullRegion::kBow));
  BOOST_TEST((box.at({9.5, 3.0, 0.0}, {0.0, 1.0, 0.0}) == HullRegion::kShoulders));
  BOOST_TEST((box.at({0.0, 3.0, 0.0}, {0.0, 1.0, 0.0}) == HullRegion::kSides));
  const model::StructureSection cone{
      .shape = model::Cone{.angle = radians(60.0), .waterline_width = 10.0, .height = 8.0, .height_under_water = 5.0},
      .motion = {}};
  BOOST_TEST(!regions_of(cone, *make_hull(cone)));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
