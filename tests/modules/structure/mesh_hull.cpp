// SPDX-License-Identifier: GPL-3.0-or-later
// Hulls from meshes against closed forms and against the same shapes with plane sides.
#include "mesh_hull.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <random>

#include "brash/geometry/ice_sheet.hpp"
#include "brash/structure/inner_radius.hpp"
#include "convex_bodies.hpp"
#include "meshes.hpp"
#include "triangle_mesh.hpp"

namespace {

using namespace brash;
using namespace brash::structure;
using namespace brash::structure::test;

const auto kExact = boost::test_tools::tolerance(1e-12);
/// Outlines lie on a grid of a micrometre and leave out vertices within 1e-5 of the hull's extent.
const auto kOutline = boost::test_tools::tolerance(1e-4);

const model::Cone kCone{radians(61.4), 13.6, 9.08, 5.68, model::Breaking::kDownward, 64};

Pose turned(double angle, Vec3 axis, Vec3 position = {}) {
  const double s = std::sin(0.5 * angle);
  return {position, {std::cos(0.5 * angle), s * axis.x, s * axis.y, s * axis.z}};
}

/// Two hulls of 40 m by 4 m, 10 m apart.
TriangleMesh catamaran() {
  return joined(box({-20.0, 5.0, -3.0}, {20.0, 9.0, 2.0}), box({-20.0, -9.0, -3.0}, {20.0, -5.0, 2.0}));
}

/// A channel, open aft: its first vertex sees all the others.
const Outline kAngleRing{{0.0, 0.0}, {8.0, 0.0}, {8.0, 2.0}, {2.0, 2.0}, {2.0, 8.0}, {0.0, 8.0}};

BOOST_AUTO_TEST_SUITE(mesh_hull)

BOOST_AUTO_TEST_CASE(the_inner_radius_of_a_convex_part_is_that_of_its_largest_ball) {
  const auto close = boost::test_tools::tolerance(1e-8);
  BOOST_TEST(inner_radius(box({0.0, 0.0, 0.0}, {4.0, 0.15, 2.0}).vertices) == 0.075, close);
  // A regular tetrahedron with edges of sqrt 2, a quarter of a corner of a box, and the same as thin as a film.
  BOOST_TEST(inner_radius({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}) == 1.0 / std::sqrt(12.0), close);
  BOOST_TEST(inner_radius({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) == 1.0 / (3.0 + std::sqrt(3.0)), close);
  const double a = 1e-4;  // the ball touches three planes through the origin and x + y + z / a = 1
  BOOST_TEST(
      inner_radius({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, a}}) == a / (1.0 + 2.0 * a + std::sqrt(1 + 2 * a * a)),
      boost::test_tools::tolerance(1e-4));  // 1e-8 of the extent
  // A wedge of 5 degrees, 2 m long and 3 m wide: its end face is a triangle.
  const double high = 2.0 * std::tan(radians(5.0)), slope = 2.0 / std::cos(radians(5.0));
  BOOST_TEST(inner_radius({{0, 0, 0}, {2, 0, 0}, {2, 0, high}, {0, 3, 0}, {2, 3, 0}, {2, 3, high}}) ==
                 2.0 * high / (2.0 + high + slope),
             close);
  BOOST_TEST(inner_radius(sphere({5.0, 0.0, 0.0}, 1.0, 40).vertices) == 1.0,
             boost::test_tools::tolerance(4e-3));  // its facets
}

BOOST_AUTO_TEST_CASE(the_search_for_the_inner_radius_ends_with_enough) {
  const ConvexPart part = box({0.0, 0.0, 0.0}, {4.0, 2.0, 2.0}).vertices;
  BOOST_TEST(inner_radius(part, 0.1) >= 0.1);
  BOOST_TEST(inner_radius({{0, 0, 0}, {10, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 0.2) >= 0.2);
  BOOST_TEST(inner_radius(part, 1.1) == 1.0, boost::test_tools::tolerance(1e-8));
}

BOOST_AUTO_TEST_CASE(a_cone_as_a_mesh_of_itself_has_the_cones_footprint) {
  const auto cone = make_hull(kCone);
  const MeshHull mesh = hull(cone->mesh());
  const Pose pose{{12.3456, -7.8, 0.1}, {}};
  for (const auto& [bottom, top] : {std::pair{-0.29, 0.04}, std::pair{-1.2, 0.4}}) {
    const Footprint one = mesh.footprint(pose, bottom, top), other = cone->footprint(pose, bottom, top);
    BOOST_REQUIRE(one.leading.size() == 1U);
    BOOST_REQUIRE(one.trailing.size() == 1U);
    BOOST_TEST(area(one.leading) == area(other.leading), kOutline);
    // Moved in by 0.17 % of the thickness, so that a vertical face would keep a strip of ice.
    const double radius = 6.8 + (bottom - 0.1) / std::tan(radians(61.4));
    const double strip = 2.0 * kPi * radius * 1.745e-3 * (top - bottom);
    BOOST_TEST(area(one.trailing) + strip == area(other.trailing), kOutline);
  }
}

BOOST_AUTO_TEST_CASE(a_cone_as_a_mesh_of_itself_has_the_cones_slope_and_displacement) {
  const auto cone = make_hull(kCone);
  const MeshHull mesh = hull(cone->mesh());
  for (const double around : {0.1, 1.3, 3.0, 5.5}) {
    const Vec3 point{6.8 * std::cos(around), 6.8 * std::sin(around), 0.0};
    const Surface here = mesh.surface_at({}, point);
    BOOST_TEST(here.slope == radians(61.4), boost::test_tools::tolerance(1e-3));
    BOOST_TEST(dot(here.normal, cone->surface_at({}, point).normal) > 0.998);
    BOOST_TEST((here.breaking == model::Breaking::kDownward));
  }
  // 64 facets: sin(2 pi / n) / (2 pi / n) of the circle.
  BOOST_TEST(mesh.displaced({}).volume == cone->displaced({}).volume * std::sin(kPi / 32.0) / (kPi / 32.0), kExact);
}

BOOST_AUTO_TEST_CASE(the_section_of_a_tilted_box_is_the_boxs) {
  const MeshHull mesh = hull(box({-2.0, -1.0, -1.0}, {2.0, 1.0, 2.0}));
  const double angle = radians(20.0);
  const Footprint f = mesh.footprint(turned(angle, {1.0, 0.0, 0.0}), 0.0, 0.0);
  BOOST_REQUIRE(f.leading.size() == 1U);
  BOOST_TEST(area(f.leading) == 4.0 * 2.0 / std::cos(angle), kOutline);
}

BOOST_AUTO_TEST_CASE(hulls_side_by_side_touch_the_ice_in_two_places) {
  const Footprint f = hull(catamaran()).footprint({}, -0.3, 0.1);
  BOOST_REQUIRE(f.leading.size() == 2U);
  BOOST_REQUIRE(f.trailing.size() == 2U);
  BOOST_TEST(area(f.leading) == 2.0 * 160.0, kOutline);
}

BOOST_AUTO_TEST_CASE(a_hollow_section_stays_hollow) {
  const Footprint f = hull(prism(kAngleRing, -3.0, 2.0)).footprint({}, -0.3, 0.1);
  BOOST_REQUIRE(f.leading.size() == 1U);
  BOOST_TEST(area(f.leading) == 28.0, kOutline);
}

BOOST_AUTO_TEST_CASE(a_bulge_within_the_ice_leads_and_does_not_trail) {
  const double radius = 4.0, bottom = -0.9, top = 0.7;
  const Footprint f = hull(sphere({}, radius, 128)).footprint({}, bottom, top);
  BOOST_TEST(area(f.leading) == kPi * radius * radius, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(area(f.trailing) == kPi * (radius * radius - bottom * bottom), boost::test_tools::tolerance(2e-3));
}

BOOST_AUTO_TEST_CASE(a_hull_above_or_below_the_ice_has_no_footprint) {
  const MeshHull mesh = hull(box({-2.0, -1.0, -1.0}, {2.0, 1.0, 2.0}));
  BOOST_TEST(mesh.footprint({{0.0, 0.0, 5.0}, {}}, -0.3, 0.1).leading.empty());
  BOOST_TEST(mesh.footprint({{0.0, 0.0, -5.0}, {}}, -0.3, 0.1).leading.empty());
  const Footprint deck = mesh.footprint({{0.0, 0.0, -2.0}, {}}, -0.3, 0.1);
  BOOST_TEST(area(deck.leading) == 8.0, kOutline);
  BOOST_TEST(deck.trailing.empty());
}

BOOST_AUTO_TEST_CASE(a_vertical_side_keeps_a_strip_of_ice_with_the_area_of_the_face) {
  const double bottom = -0.3, top = 0.1;
  const MeshHull mesh = hull(box({-2.0, -1.0, -1.0}, {2.0, 1.0, 2.0}));
  const Footprint f = mesh.footprint({}, bottom, top);
  double facing = 0.0;
  for (const SidePiece& piece : mesh.sides({}, bottom, top, {{1.9, -5.0}, {5.0, 5.0}})) {
    if (piece.normal.x < 0.9) continue;
    BOOST_TEST(piece.normal.z == -1.745e-3, boost::test_tools::tolerance(1e-3));
    for (const Vec3 v : piece.outline) BOOST_TEST(v.x <= 2.0);
    const Vec3 a = piece.outline[0];
    for (std::size_t i = 2; i < piece.outline.size(); ++i)
      facing += 0.5 * norm(cross(piece.outline[i - 1] - a, piece.outline[i] - a));
  }
  BOOST_TEST(facing == 2.0 * (top - bottom), boost::test_tools::tolerance(1e-5));
  const double strip = 1.745e-3 * (top - bottom);
  BOOST_TEST(area(f.trailing) == (4.0 - 2.0 * strip) * (2.0 - 2.0 * strip), boost::test_tools::tolerance(1e-5));
}

/// The wall of a mesh lost its load wherever the grid rounds its strip of ice inwards: at half of all places.
BOOST_AUTO_TEST_CASE(a_vertical_side_is_found_wherever_the_grid_rounds_its_strip) {
  const double bottom = -0.3, top = 0.1;
  const MeshHull mesh = hull(box({-2.0, -1.0, -1.0}, {2.0, 1.0, 2.0}));
  for (int i = 0; i < 50; ++i) {
    const Pose pose{{0.0123456789 * i, 0.0, 0.0}, {}};
    const geometry::Extent front = geometry::extent({geometry::ring(mesh.footprint(pose, bottom, top).leading[0]), {}});
    const auto sides = mesh.sides(pose, bottom, top, {{front.upper.x - 1e-4, -0.5}, front.upper});
    BOOST_TEST(std::ranges::any_of(sides, [](const SidePiece& side) { return side.normal.x > 0.9; }));
  }
}

BOOST_AUTO_TEST_CASE(only_sides_near_a_region_are_listed) {
  const MeshHull mesh = hull(sphere({}, 4.0, 64));
  const auto all = mesh.sides({}, -0.3, 0.1, {}), ahead = mesh.sides({}, -0.3, 0.1, {{3.9, -0.2}, {5.0, 0.2}});
  BOOST_TEST(!ahead.empty());
  BOOST_TEST(ahead.size() * 10 < all.size());
}

BOOST_AUTO_TEST_CASE(a_heeled_box_displaces_as_its_closed_form_says) {
  // While deck and keel stay clear: the volume keeps, and the centre of buoyancy moves by I / V tan(angle).
  const double angle = radians(10.0), draught = 1.0, breadth = 2.0;
  const MeshHull mesh = hull(box({-5.0, -1.0, -draught}, {5.0, 1.0, 2.0}));
  const Displacement wet = mesh.displaced(turned(angle, {1.0, 0.0, 0.0}));
  BOOST_TEST(wet.volume == 10.0 * breadth * draught, kExact);
  BOOST_TEST(wet.waterplane.area == 10.0 * breadth / std::cos(angle), kExact);
  const double across = breadth * breadth / (12.0 * draught) * std::tan(angle);  // of the body, to the low side
  const double height = -0.5 * draught + 0.5 * across * std::tan(angle);
  BOOST_TEST(wet.centre.y == -across * std::cos(angle) - height * std::sin(angle), kExact);
  BOOST_TEST(wet.centre.z == -across * std::sin(angle) + height * std::cos(angle), kExact);
}

BOOST_AUTO_TEST_CASE(a_sphere_displaces_a_cap_and_more_triangles_come_nearer) {
  const double radius = 3.0, height = 1.2;  // of the cap
  const double volume = kPi * height * height * (3.0 * radius - height) / 3.0;
  double before = HUGE_VAL;
  for (const int n : {32, 64, 128}) {
    const Displacement wet = hull(sphere({0.0, 0.0, radius - height}, radius, n)).displaced({});
    const double error = std::abs(wet.volume / volume - 1.0);
    // The error falls with the square of the triangles' size.
    BOOST_TEST(error < 0.3 * before);
    before = error;
    BOOST_TEST(error < 8.0 / (n * n));
  }
}

BOOST_AUTO_TEST_CASE(a_convex_hull_is_one_part_and_a_hollow_one_is_cut_into_parts_of_the_right_volume) {
  const ConvexBodies ball = convex_bodies(sphere({}, 4.0, 96));
  BOOST_TEST(ball.parts.size() == 1U);
  BOOST_TEST(ball.parts.front().size() <= 256U);
  BOOST_TEST(ball.error < 0.03);
  const ConvexBodies two = convex_bodies(catamaran());
  BOOST_TEST(two.parts.size() == 2U);
  BOOST_TEST(two.error < 1e-9);
  const ConvexBodies angle = convex_bodies(prism(kAngleRing, -3.0, 2.0));
  BOOST_TEST(angle.parts.size() > 1U);
  BOOST_TEST(angle.parts.size() <= 32U);
  BOOST_TEST(angle.error <= 0.011);
}

/// Parts of turned meshes have faces that are lower than round-off. The search for their corners went on for ever.
BOOST_AUTO_TEST_CASE(a_coarse_ring_is_cut_into_parts_at_any_turn) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int i = 0; i < 20; ++i) {
    TriangleMesh ring = torus(8.0, 3.0, 3 + i % 4, 3 + i % 3);
    const Vec3 axis = normalized(Vec3{unit(random), unit(random), unit(random)});
    const Pose pose = turned(3.0 * unit(random), axis);
    for (Vec3& v : ring.vertices) v = to_world(pose, v);
    const ConvexBodies bodies = convex_bodies(ring);
    BOOST_TEST(bodies.parts.size() > 1U);
    BOOST_TEST(bodies.parts.size() <= 32U);
    BOOST_TEST(bodies.error < 0.5);
  }
}

BOOST_AUTO_TEST_CASE(a_hull_of_many_triangles_is_one_part_of_nearly_its_volume) {
  // A barge with a flat deck of 160 x 100 places: CGAL alone took half a minute.
  TriangleMesh mesh = sphere({}, 10.0, 170);
  for (Vec3& v : mesh.vertices) v = {3.0 * v.x, v.y, std::min(v.z, 2.0)};
  BOOST_REQUIRE(mesh.vertices.size() > 50'000u);
  const ConvexBodies bodies = convex_bodies(mesh);
  BOOST_REQUIRE(bodies.parts.size() == 1u);
  BOOST_TEST(bodies.parts[0].size() <= 256u);
  BOOST_TEST(bodies.error < 0.03);
}

BOOST_AUTO_TEST_CASE(extreme_points_are_the_farthest_of_all_points) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<Vec3> cloud;
  for (int i = 0; i < 3000; ++i) cloud.push_back({5.0 * unit(random), unit(random), 0.2 * unit(random)});
  for (std::vector<Vec3> points :
       {cloud, sphere({1.0, 2.0, 3.0}, 4.0, 40).vertices, box({0, 0, 0}, {2, 3, 4}).vertices}) {
    keep_one_of_each(points);
    std::vector<Vec3> far;
    for (int i = 0; i < 200; ++i) {
      const Vec3 towards = spread_direction(i, 200);
      far.push_back(*std::ranges::max_element(points, {}, [&](const Vec3& v) { return dot(towards, v); }));
    }
    keep_one_of_each(far);
    BOOST_TEST((extreme_points(points, 200) == far));
  }
}

/// Outlines of any pose are simple rings that the exact geometry takes: the bow, stern and legs of what there is.
BOOST_AUTO_TEST_CASE(outlines_at_any_pose_are_simple_rings) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const std::vector<MeshHull> hulls{hull(sphere({}, 4.0, 64)), hull(catamaran()), hull(prism(kAngleRing, -3.0, 2.0)),
                                    hull(make_hull(kCone)->mesh())};
  const Outline field{{-30.0, -30.0}, {30.0, -30.0}, {30.0, 30.0}, {-30.0, 30.0}};
  const auto sheet = geometry::IceSheet::from_polygons(std::vector<geometry::Polygon>{{geometry::ring(field), {}}});
  std::size_t n_rings = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3 axis = normalized({unit(random), unit(random), unit(random)});
    const Pose pose = turned(0.3 * unit(random), axis, {unit(random), unit(random), 0.5 * unit(random)});
    const Footprint f = hulls[static_cast<std::size_t>(i) % hulls.size()].footprint(pose, -0.3, 0.1);
    for (const auto* outlines : {&f.leading, &f.trailing})
      for (const Outline& outline : *outlines) {
        BOOST_TEST(sheet->contacts(geometry::ring(outline)).size() >= 1U);
        ++n_rings;
      }
    BOOST_TEST(area(f.trailing) <= area(f.leading));
  }
  BOOST_TEST(n_rings >= 400U);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
