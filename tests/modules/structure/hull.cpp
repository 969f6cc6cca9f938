// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/structure/hull.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "frustum.hpp"

namespace {

using namespace brash;
using structure::Hull;
using structure::Outline;

const model::Cone kPaperCone{radians(61.4), 13.6, 9.08, 5.68, model::Breaking::kDownward, 64};

model::Cone upward() {
  model::Cone cone = kPaperCone;
  cone.breaking = model::Breaking::kUpward;
  return cone;
}

/// Radius of the round cone at height z [m].
double radius(double z) { return 6.8 + z / std::tan(radians(61.4)); }

/// A box of 4 m by 2 m, 1 m under water and 2 m above.
const structure::Frustum& box() {
  static const structure::Frustum made({{-2, -1, -1}, {2, -1, -1}, {2, 1, -1}, {-2, 1, -1}},
                                       {{-2, -1, 2}, {2, -1, 2}, {2, 1, 2}, {-2, 1, 2}});
  return made;
}

/// The attitude after a turn about y that lifts the bow.
Pose pitched(double angle, Vec3 position = {}) {
  return {position, {std::cos(0.5 * angle), 0, -std::sin(0.5 * angle), 0}};
}

double area(const Outline& outline) {
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) twice += cross(outline[i], outline[(i + 1) % outline.size()]);
  return 0.5 * twice;
}

const auto kExact = boost::test_tools::tolerance(1e-12);

BOOST_AUTO_TEST_SUITE(hull)

BOOST_AUTO_TEST_CASE(the_fitted_ellipsoid_has_the_waterline_and_the_volume_of_the_hull) {
  // A box of 4 m by 2 m: the ellipse has its area, and axes of the same ratio.
  const structure::HalfEllipsoid fitted = structure::fitted_ellipsoid(box());
  const auto& [x, y, z] = fitted.semi_axes;
  BOOST_TEST(kPi * x * y == 8.0, kExact);
  BOOST_TEST(x / y == 2.0, kExact);
  BOOST_TEST(2.0 / 3.0 * kPi * x * y * z == 8.0, kExact);
  BOOST_TEST(fitted.heading == 0.0);

  // Turned by 30 degrees beside its origin.
  const double c = std::cos(radians(30)), s = std::sin(radians(30));
  std::vector<Vec3> lower, upper;
  for (const Vec2 v : {Vec2{-2, -1}, {2, -1}, {2, 1}, {-2, 1}}) {
    lower.push_back({3.0 + c * v.x - s * v.y, -1.0 + s * v.x + c * v.y, -1.0});
    upper.push_back({lower.back().x, lower.back().y, 2.0});
  }
  const structure::HalfEllipsoid turned = structure::fitted_ellipsoid(structure::Frustum(lower, upper));
  BOOST_TEST(turned.heading == radians(30), kExact);
  BOOST_TEST(norm(turned.centre - Vec2{3.0, -1.0}) < 1e-12);
  BOOST_TEST(turned.semi_axes.x == x, kExact);

  // The cone's is round, with its radius.
  const auto cone = structure::fitted_ellipsoid(*structure::make_hull(kPaperCone));
  BOOST_TEST(cone.semi_axes.x == 6.8, kExact);
  BOOST_TEST(cone.semi_axes.y == 6.8, kExact);
}

BOOST_AUTO_TEST_CASE(the_papers_cone_has_the_keel_and_top_widths_of_its_slope) {
  // Table 1: 5.68 m below and 3.40 m above the waterplane at 61.4 deg; both widths rounded to the centimetre.
  const auto hull = structure::make_hull(kPaperCone);
  const auto [least, most] = hull->bounds();
  BOOST_TEST(least.z == -5.68);
  BOOST_TEST(most.z == 3.40, kExact);
  BOOST_TEST(most.x - least.x == 17.31, boost::test_tools::tolerance(1e-3));
  const Outline keel = hull->footprint({}, -5.68, -5.68).leading.at(0);
  BOOST_TEST(2.0 * keel.front().x == 7.41, boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(a_downward_cone_leads_with_its_section_at_the_ice_s_top_and_trails_with_that_at_its_bottom) {
  const Pose pose{{3.0, -2.0, 0.0}, {}};
  const structure::Footprint f = structure::make_hull(kPaperCone)->footprint(pose, -0.29, 0.04);
  BOOST_REQUIRE_EQUAL(f.leading.size(), 1u);
  BOOST_REQUIRE_EQUAL(f.trailing.size(), 1u);
  for (const Vec2 v : f.leading[0]) BOOST_TEST(norm(v - Vec2{3.0, -2.0}) == radius(0.04), kExact);
  for (const Vec2 v : f.trailing[0]) BOOST_TEST(norm(v - Vec2{3.0, -2.0}) == radius(-0.29), kExact);
  BOOST_TEST(area(f.leading[0]) > 0.0);  // counter-clockwise
}

BOOST_AUTO_TEST_CASE(an_upward_cone_leads_at_the_ice_s_bottom) {
  const structure::Footprint f = structure::make_hull(upward())->footprint({}, -0.29, 0.04);
  BOOST_TEST(norm(f.leading.at(0)[5]) == radius(0.29), kExact);
  BOOST_TEST(norm(f.trailing.at(0)[5]) == radius(-0.04), kExact);
}

BOOST_AUTO_TEST_CASE(a_hull_above_the_ice_touches_nothing_and_one_whose_keel_is_in_it_has_passed_through_nothing) {
  const auto hull = structure::make_hull(kPaperCone);
  const structure::Footprint above = hull->footprint({{0.0, 0.0, 6.0}, {}}, -0.29, 0.04);
  BOOST_TEST((above.leading.empty() && above.trailing.empty()));
  const structure::Footprint within = hull->footprint({{0.0, 0.0, 5.58}, {}}, -0.29, 0.04);
  BOOST_TEST(within.leading.size() == 1u);
  BOOST_TEST(within.trailing.empty());
}

BOOST_AUTO_TEST_CASE(a_pitched_box_touches_the_union_of_its_sections_and_has_passed_through_their_intersection) {
  // The ends lean by the pitch: over the slab's 0.6 m the sections of 4 m / cos move by 0.6 m tan.
  const double pitch = 0.2;
  const structure::Footprint f = box().footprint(pitched(pitch), -0.3, 0.3);
  BOOST_REQUIRE((f.leading.size() == 1u && f.trailing.size() == 1u));
  const double length = 4.0 / std::cos(pitch), shift = 0.6 * std::tan(pitch);
  BOOST_TEST(area(f.leading[0]) == 2.0 * (length + shift), kExact);
  const double strip = 0.6 * std::tan(radians(0.1));  // of ice at each side, which stays vertical
  BOOST_TEST(area(f.trailing[0]) == (2.0 - 2.0 * strip) * (length - shift), boost::test_tools::tolerance(1e-8));
}

BOOST_AUTO_TEST_CASE(a_cone_that_hardly_heels_has_nearly_the_footprint_of_the_upright_one) {
  const auto hull = structure::make_hull(kPaperCone);
  const structure::Footprint upright = hull->footprint({}, -0.29, 0.04);
  const structure::Footprint heeled = hull->footprint(pitched(1e-9), -0.29, 0.04);
  BOOST_TEST(area(heeled.leading.at(0)) == area(upright.leading[0]), boost::test_tools::tolerance(1e-6));
  BOOST_TEST(area(heeled.trailing.at(0)) == area(upright.trailing[0]), boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(the_surface_of_a_cone_has_its_slope_all_round_and_bends_the_ice_its_way) {
  for (const double angle : {0.0, 0.7, 2.5, -2.0}) {
    const Vec3 point{1.0 + 6.8 * std::cos(angle), 6.8 * std::sin(angle), 0.0};
    const structure::Surface down = structure::make_hull(kPaperCone)->surface_at({{1.0, 0.0, 0.0}, {}}, point);
    BOOST_TEST(down.slope == radians(61.4));
    BOOST_TEST((down.breaking == model::Breaking::kDownward));
    BOOST_TEST(down.normal.z == -std::cos(radians(61.4)), kExact);
    BOOST_TEST(std::atan2(down.normal.y, down.normal.x) == angle, boost::test_tools::tolerance(1e-9));
    BOOST_TEST((structure::make_hull(upward())->surface_at({}, point).breaking == model::Breaking::kUpward));
  }
}

BOOST_AUTO_TEST_CASE(a_cone_pitched_by_the_bow_is_steeper_ahead_and_flatter_astern) {
  const auto hull = structure::make_hull(kPaperCone);
  const Pose pose = pitched(radians(10.0));
  BOOST_TEST(hull->surface_at(pose, {7.0, 0.0, 0.0}).slope == radians(71.4), kExact);
  BOOST_TEST(hull->surface_at(pose, {-7.0, 0.0, 0.0}).slope == radians(51.4), kExact);
}

BOOST_AUTO_TEST_CASE(the_sides_of_a_box_are_vertical_until_it_pitches) {
  BOOST_TEST(box().surface_at({}, {1.9, 0.2, 0.0}).slope == 0.5 * kPi, kExact);
  BOOST_TEST(box().surface_at({}, {0.0, 0.9, 0.0}).normal.y == 1.0, kExact);
  const structure::Surface bow = box().surface_at(pitched(0.2), {1.9, 0.2, 0.0});
  BOOST_TEST(bow.slope == 0.5 * kPi - 0.2, kExact);
  BOOST_TEST((bow.breaking == model::Breaking::kUpward));
}

BOOST_AUTO_TEST_CASE(a_round_cone_displaces_what_its_closed_form_says) {
  const structure::Displacement wet = structure::make_hull(kPaperCone)->displaced({{2.0, 1.0, 0.0}, {}});
  const double k = radius(-5.68), w = 6.8;
  BOOST_TEST(wet.volume == kPi * 5.68 / 3.0 * (w * w + w * k + k * k), kExact);
  BOOST_TEST(wet.waterplane.radius == 6.8);
  BOOST_TEST(wet.waterplane.area == kPi * 6.8 * 6.8, kExact);
  // The centroid by the integral of z pi r^2 from keel to waterplane, midpoint rule.
  double moment = 0.0;
  constexpr int kSlices = 20000;
  for (int i = 0; i < kSlices; ++i) {
    const double z = -5.68 * (i + 0.5) / kSlices;
    moment += z * kPi * radius(z) * radius(z) * 5.68 / kSlices;
  }
  BOOST_TEST(wet.centre.z == moment / wet.volume, boost::test_tools::tolerance(1e-8));
  BOOST_TEST(wet.centre.x == 2.0, kExact);
}

BOOST_AUTO_TEST_CASE(the_faceted_cone_displaces_the_round_one_less_its_segments) {
  const auto hull = structure::make_hull(kPaperCone);
  const double share = std::sin(2.0 * kPi / 64) / (2.0 * kPi / 64);
  const structure::Displacement round = hull->displaced({}), faceted = hull->displaced(pitched(1e-9));
  BOOST_TEST(faceted.volume == share * round.volume, boost::test_tools::tolerance(1e-7));
  BOOST_TEST(faceted.waterplane.area == share * round.waterplane.area, boost::test_tools::tolerance(1e-7));
  BOOST_TEST(faceted.centre.z == round.centre.z, boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(a_box_displaces_by_archimedes_wherever_it_lies) {
  const structure::Displacement level = box().displaced({{5.0, 3.0, -0.5}, {}});
  BOOST_TEST(level.volume == 4.0 * 2.0 * 1.5, kExact);
  BOOST_TEST(level.centre.x == 5.0, kExact);
  BOOST_TEST(level.centre.z == -0.75, kExact);
  BOOST_TEST(level.waterplane.area == 8.0, kExact);
  BOOST_TEST(level.waterplane.centre.y == 3.0, kExact);
  // Pitched by a, its middle line still 1 m deep: the volume stays, the centre of buoyancy moves by I tan(a) / V.
  const double a = 0.2;
  const structure::Displacement pitch = box().displaced(pitched(a));
  BOOST_TEST(pitch.volume == 8.0, kExact);
  const Vec3 centre = to_body(pitched(a), pitch.centre);
  BOOST_TEST(centre.x == -(2.0 * 64.0 / 12.0) * std::tan(a) / 8.0, kExact);
  BOOST_TEST(box().displaced({{0.0, 0.0, 3.0}, {}}).volume == 0.0);
}

BOOST_AUTO_TEST_CASE(a_mesh_is_closed_and_its_triangles_look_outwards) {
  const auto cone = structure::make_hull(kPaperCone);
  for (const Hull* hull : {cone.get(), static_cast<const Hull*>(&box())}) {
    const auto& [vertices, triangles] = hull->mesh();
    std::map<std::pair<int, int>, int> edges;
    double volume = 0.0;
    for (const auto& t : triangles) {
      for (std::size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
      const auto at = [&, &corners = vertices](int i) { return corners[static_cast<std::size_t>(i)]; };
      volume += dot(at(t[0]), cross(at(t[1]), at(t[2]))) / 6.0;
    }
    for (const auto& [edge, n] : edges) {
      BOOST_TEST(n == 1);
      BOOST_TEST(edges.contains({edge.second, edge.first}));
    }
    // Sunk, it displaces all of itself.
    BOOST_TEST(volume == hull->displaced({{0.0, 0.0, -20.0}, {}}).volume, kExact);
  }
}

BOOST_AUTO_TEST_CASE(a_straight_front_is_met_in_its_middle) {
  const structure::Foremost bow = structure::foremost(box(), {{1.0, 0.0, 0.0}, {}}, -0.3, 0.03, {2.0, 0.0});
  BOOST_TEST(bow.reach == 3.0, kExact);
  BOOST_TEST(bow.surface.normal.x == 1.0, kExact);
}

BOOST_AUTO_TEST_CASE(a_cone_without_a_keel_breaks_the_contract) {
  model::Cone cone = kPaperCone;
  cone.waterline_width = 6.0;
  BOOST_CHECK_THROW(structure::make_hull(cone), ContractViolation);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
