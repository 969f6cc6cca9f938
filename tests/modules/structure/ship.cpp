// SPDX-License-Identifier: GPL-3.0-or-later
// The parametric icebreaker against the integrals of its curves.
#include "brash/structure/ship.hpp"

#include <boost/test/unit_test.hpp>

#include "meshes.hpp"

namespace {

using namespace brash;
using namespace brash::structure;

/// 24 chords to a curve: their area is 1 / (4 n^2) = 0.04 % short.
const auto kChords = boost::test_tools::tolerance(5e-4);
const auto kExact = boost::test_tools::tolerance(1e-12);

model::HullSection icebreaker() {
  model::HullSection hull;
  hull.length = 90.0;
  hull.breadth = 20.0;
  hull.draught = 7.0;
  hull.stem_angle = radians(25.0);
  hull.waterline_angle = radians(35.0);
  return hull;
}

double cot(double angle) { return 1.0 / std::tan(angle); }

BOOST_AUTO_TEST_SUITE(ship)

BOOST_AUTO_TEST_CASE(the_waterline_has_the_area_of_two_parabolas_and_a_rectangle) {
  const auto hull = make_hull(model::Ship{icebreaker()});
  const double entrance = 20.0 * cot(radians(35.0)), midbody = 0.5 * (90.0 - entrance);
  const double area = 20.0 * (2.0 / 3.0 * (90.0 - midbody) + midbody);
  BOOST_TEST(hull->displaced({}).waterplane.area == area, kChords);
  const auto [least, most] = hull->bounds();
  BOOST_TEST(least.z == -7.0, kExact);
  BOOST_TEST(most.z == 3.5, kExact);
  BOOST_TEST(most.y == 10.0, kExact);
}

BOOST_AUTO_TEST_CASE(its_displacement_is_the_integral_of_its_waterlines) {
  const auto hull = make_hull(model::Ship{icebreaker()});
  const double draught = 7.0, entrance = 20.0 * cot(radians(35.0)), midbody = 0.5 * (90.0 - entrance);
  const double lean = cot(radians(25.0)) + 1.0;  // of stem and stern
  // docs/theory/structures.md, (K6): below the water bow and stern draw in, and the parallel part shortens.
  const double volume = 20.0 * draught * (2.0 / 3.0 * (90.0 - midbody) + midbody - 0.5 * lean * draught);
  BOOST_TEST(hull->displaced({}).volume == volume, kChords);
}

BOOST_AUTO_TEST_CASE(a_longer_bow_of_the_same_angle_is_fuller_and_the_shortest_one_is_a_wedge) {
  model::HullSection section = icebreaker();
  section.midbody = 30.0;
  const double wedge = 10.0 * cot(radians(35.0));
  for (const double fullness : {1.0, 2.0, 3.0}) {
    section.bow_length = fullness * wedge;
    const double bow = fullness / (fullness + 1.0) * fullness * wedge, run = 90.0 - 30.0 - fullness * wedge;
    const auto hull = make_hull(model::Ship{section});
    BOOST_TEST(hull->displaced({}).waterplane.area == 20.0 * (bow + 30.0 + 2.0 / 3.0 * run),
               boost::test_tools::tolerance(1e-3));
  }
}

BOOST_AUTO_TEST_CASE(its_stem_and_sides_have_their_angles) {
  model::HullSection section = icebreaker();
  section.flare = radians(8.0);
  section.midbody = 40.0;
  const auto hull = make_hull(model::Ship{section});
  // tan(slope) = tan(stem angle) / sin(waterline angle) at the stem; a first chord away from it the angle is smaller.
  const double at_stem = std::atan(std::tan(radians(25.0)) / std::sin(radians(35.0)));
  const Foremost bow = foremost(*hull, {}, 0.0, 0.0, {1.0, 0.0});
  BOOST_TEST(bow.reach == 45.0, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(bow.surface.slope == at_stem, boost::test_tools::tolerance(0.02));
  BOOST_TEST((bow.surface.breaking == model::Breaking::kDownward));
  const Surface side = hull->surface_at({}, {0.0, 10.0, 0.0});
  BOOST_TEST(side.slope == radians(82.0), boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(it_is_one_convex_part_with_the_corners_of_its_mesh) {
  model::HullSection section = icebreaker();
  section.flare = radians(8.0);
  section.midbody = 40.0;
  const auto hull = make_hull(model::Ship{section});
  BOOST_TEST(hull->parts().size() == 1U);
  BOOST_TEST(hull->parts().front().size() > 150U);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
