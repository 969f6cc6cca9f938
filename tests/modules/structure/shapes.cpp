// SPDX-License-Identifier: GPL-3.0-or-later
// Hulls with plane sides against closed forms.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/structure/hull.hpp"

namespace {

using namespace brash;

const auto kExact = boost::test_tools::tolerance(1e-12);
const double kAngle = radians(60.0), kCot = 1.0 / std::tan(kAngle);

double area(const structure::Outline& outline) {
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) twice += cross(outline[i], outline[(i + 1) % outline.size()]);
  return 0.5 * twice;
}

double section_area(const structure::Hull& hull, double z) { return area(hull.footprint({}, z, z).leading.at(0)); }

/// Simpson's rule is exact for the volume between two similar sections.
double volume_to_waterline(const structure::Hull& hull, double keel) {
  const double near_keel = keel + 1e-9;
  return -keel / 6.0 * (section_area(hull, near_keel) + 4.0 * section_area(hull, 0.5 * keel) + section_area(hull, 0.0));
}

BOOST_AUTO_TEST_SUITE(shapes)

BOOST_AUTO_TEST_CASE(a_faceted_cone_is_a_pyramid_around_its_circle_with_one_side_ahead) {
  const auto hull = structure::make_hull(model::FacetedCone{kAngle, 10.0, 6.0, 4.0, model::Breaking::kDownward, 8});
  for (const double z : {-3.0, 0.0, 1.5}) {
    const double radius = 5.0 + z * kCot;
    BOOST_TEST(section_area(*hull, z) == 8.0 * radius * radius * std::tan(kPi / 8.0), kExact);
  }
  BOOST_TEST(hull->displaced({}).volume == volume_to_waterline(*hull, -4.0), boost::test_tools::tolerance(1e-8));
  const structure::Surface ahead = hull->surface_at({}, {5.0, 0.2, 0.0});
  BOOST_TEST(ahead.slope == kAngle, kExact);
  BOOST_TEST(ahead.normal.y == 0.0);
  BOOST_TEST((ahead.breaking == model::Breaking::kDownward));
}

BOOST_AUTO_TEST_CASE(a_faceted_cone_with_many_sides_is_the_round_cone) {
  const auto faceted = structure::make_hull(model::FacetedCone{kAngle, 10.0, 6.0, 4.0, model::Breaking::kUpward, 64});
  const auto round = structure::make_hull(model::Cone{kAngle, 10.0, 6.0, 4.0, model::Breaking::kUpward, 64});
  BOOST_TEST(faceted->displaced({}).volume == round->displaced({}).volume, boost::test_tools::tolerance(1e-3));
  const Vec3 point{3.0, 4.0, 0.0};
  BOOST_TEST(dot(faceted->surface_at({}, point).normal, round->surface_at({}, point).normal) > 0.998);
}

BOOST_AUTO_TEST_CASE(a_plane_leans_over_the_ice_ahead_and_has_vertical_sides) {
  const auto hull = structure::make_hull(model::Plane{kAngle, 8.0, 20.0, 6.0, 4.0, model::Breaking::kDownward});
  const structure::Foremost front = structure::foremost(*hull, {}, -0.3, 0.1, {1.0, 0.0});
  BOOST_TEST(front.reach == 10.0 + 0.1 * kCot, kExact);
  BOOST_TEST(front.surface.slope == kAngle, kExact);
  BOOST_TEST(structure::foremost(*hull, {}, -0.3, 0.1, {0.0, 1.0}).reach == 4.0, kExact);
  BOOST_TEST(structure::foremost(*hull, {}, -0.3, 0.1, {0.0, 1.0}).surface.slope == 0.5 * kPi, kExact);
  BOOST_TEST(hull->displaced({}).volume == 8.0 * 4.0 * (20.0 - 0.5 * 4.0 * kCot), kExact);
  // Sides and back are vertical, and lean by a tenth of a degree over the ice that they crush:
  // docs/theory/structures.md (K2).
  const structure::Footprint f = hull->footprint({}, -0.3, 0.1);
  const double strip = 0.4 * std::tan(radians(0.1)), length = 20.0 - 0.3 * kCot;
  BOOST_TEST(area(f.trailing.at(0)) == (length - strip) * (8.0 - 2.0 * strip), boost::test_tools::tolerance(1e-8));
}

BOOST_AUTO_TEST_CASE(a_vertical_side_of_any_shape_keeps_a_strip_of_ice_with_the_area_of_the_face) {
  const double upright = radians(90.0), bottom = -0.3, top = 0.1, strip = (top - bottom) * std::tan(radians(0.1));
  const model::Breaking down = model::Breaking::kDownward;
  const auto cone = structure::make_hull(model::Cone{upright, 10.0, 6.0, 4.0, down, 64});
  const auto plane = structure::make_hull(model::Plane{upright, 8.0, 20.0, 6.0, 4.0, down});
  for (const auto* hull : {cone.get(), plane.get()}) {
    const structure::Footprint f = hull->footprint({}, bottom, top);
    double perimeter = 0.0, faces = 0.0;
    const structure::Outline& around = f.leading.at(0);
    for (std::size_t i = 0; i < around.size(); ++i) perimeter += norm(around[(i + 1) % around.size()] - around[i]);
    for (const structure::SidePiece& side : hull->sides({}, bottom, top, {})) {
      const Vec3 a = side.outline[0];
      for (std::size_t i = 2; i < side.outline.size(); ++i)
        faces += 0.5 * norm(cross(side.outline[i - 1] - a, side.outline[i] - a));
    }
    BOOST_TEST(faces == perimeter * (top - bottom), boost::test_tools::tolerance(1e-5));
    BOOST_TEST(area(around) - area(f.trailing.at(0)) == perimeter * strip, boost::test_tools::tolerance(1e-3));
    BOOST_TEST(structure::foremost(*hull, {}, bottom, top, {1.0, 0.0}).surface.slope == upright, kExact);
  }
}

BOOST_AUTO_TEST_CASE(a_wedge_bow_meets_the_ice_with_two_planes_of_its_slope) {
  const double entrance = radians(30.0), half = 5.0, length = 40.0;
  const auto hull =
      structure::make_hull(model::WedgeBow{kAngle, entrance, 10.0, length, 6.0, 4.0, model::Breaking::kDownward});
  const double wedge = half / std::tan(entrance);
  BOOST_TEST(section_area(*hull, 0.0) == 10.0 * (length - wedge) + half * wedge, kExact);
  BOOST_TEST(structure::foremost(*hull, {}, 0.0, 0.0, {1.0, 0.0}).reach == 20.0, kExact);
  for (const double side : {1.0, -1.0}) {
    const structure::Surface bow = hull->surface_at({}, {20.0 - 0.5 * wedge, side * 0.5 * half, 0.0});
    BOOST_TEST(bow.slope == kAngle, kExact);
    BOOST_TEST(std::atan2(side * bow.normal.y, bow.normal.x) == 0.5 * kPi - entrance, kExact);
    BOOST_TEST(bow.normal.z < 0.0);
  }
  BOOST_TEST(hull->displaced({}).volume == volume_to_waterline(*hull, -4.0), boost::test_tools::tolerance(1e-8));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
