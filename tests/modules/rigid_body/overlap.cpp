// SPDX-License-Identifier: GPL-3.0-or-later
#include "../../../modules/rigid_body/src/overlap.hpp"

#include <boost/test/unit_test.hpp>

#include "helpers.hpp"

using namespace brash;
using namespace brash::rigid_body;
using namespace brash::rigid_body::testing;

namespace {

// Clipping coordinates of a few metres: 1e-15 each, with areas down to 1e-4 m2.
constexpr double kRoundOff = 1e-10;

Pose turned(Vec3 position, Vec3 axis, double angle) {
  const Vec3 a = std::sin(angle / 2) * normalized(axis);
  return {position, {std::cos(angle / 2), a.x, a.y, a.z}};
}

/// A cube of side 2 about the origin.
ConvexPart cube() { return convex_prism(rectangle({-1, -1}, {1, 1}), -1, 1); }

/// A slab whose upper face is z = 0.
ConvexPart ground() { return convex_prism(rectangle({-50, -50}, {50, 50}), -10, 0); }

/// Unit quaternion that turns `from` into `to` (not opposite).
Quaternion rotation_between(Vec3 from, Vec3 to) {
  const Vec3 c = cross(from, to);
  const double w = 1 + dot(from, to);
  const double n = std::sqrt(w * w + dot(c, c));
  return {w / n, c.x / n, c.y / n, c.z / n};
}

}  // namespace

BOOST_AUTO_TEST_CASE(A_corner_pressed_into_a_plane_leaves_a_triangle_that_grows_with_the_square_of_the_depth) {
  const ConvexPart corner = cube();
  const ConvexPart plane = ground();
  const PlacedPart b = placed(plane, {});
  // The diagonal (1,1,1) of the cube upright: a section at d from the corner is an equilateral triangle of side
  // d sqrt(6), and its projection is itself.
  const Quaternion upright = rotation_between(normalized(Vec3{1, 1, 1}), {0, 0, 1});
  for (const double d : {1e-4, 1e-2, 0.1, 0.5}) {
    const PlacedPart a = placed(corner, {{0, 0, std::sqrt(3.0) - d}, upright});
    BOOST_TEST(overlap_area(a, b, {0, 0, 1}) == std::sqrt(3.0) / 4 * 6 * d * d,
               boost::test_tools::tolerance(kRoundOff));
  }
}

BOOST_AUTO_TEST_CASE(An_edge_pressed_into_a_plane_leaves_a_strip) {
  const ConvexPart box = cube();
  const ConvexPart plane = ground();
  const PlacedPart b = placed(plane, {});
  for (const double d : {1e-3, 0.05, 0.4}) {
    const PlacedPart a = placed(box, turned({3, -2, std::sqrt(2.0) - d}, {1, 0, 0}, kPi / 4));
    BOOST_TEST(overlap_area(a, b, {0, 0, 1}) == 2 * (2 * d), boost::test_tools::tolerance(kRoundOff));
  }
}

BOOST_AUTO_TEST_CASE(A_floe_s_edge_pressed_by_a_facet_is_crushed_over_the_section_that_the_facet_makes) {
  // A wall inclined by `angle` moved by d into the upper edge of ice of thickness h reaches down d tan(angle):
  // its section with the ice is d / cos(angle) long while that is less than h / sin(angle).
  const double h = 0.33;
  const double width = 2.0;
  const ConvexPart ice = convex_prism(rectangle({0, 0}, {5, width}), -h, 0);
  const PlacedPart a = placed(ice, {});
  for (const double angle : {radians(50), radians(61.4), radians(70)}) {
    for (const double d : {0.01, 0.1, 0.3}) {
      const ConvexPart wall = convex_prism(rectangle({-10, -10}, {0, 10}), -10, 10);
      // The face x = 0 turned about y through the edge at (d, y, 0), overhanging (narrower below).
      const PlacedPart b = placed(wall, turned({d, 0, 0}, {0, 1, 0}, kPi / 2 - angle));
      const Vec3 normal = rotate(turned({}, {0, 1, 0}, kPi / 2 - angle).rotation, {1, 0, 0});
      const double length = std::min(d / std::cos(angle), h / std::sin(angle));
      BOOST_TEST(normal.z < 0);
      const double full = overlap_area(a, b, normal);
      if (d * std::tan(angle) <= h) {
        BOOST_TEST(full == width * length, boost::test_tools::tolerance(kRoundOff));
      } else {
        BOOST_TEST(full >= width * length);  // the ice beside the section is seen too
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(The_area_is_zero_at_first_touch_and_grows_without_a_jump) {
  const ConvexPart frustum = convex_hull(cone(6.8, radians(61.4), 5.68, 3.4));
  const ConvexPart ice = convex_prism(rectangle({6.8, -1}, {9, 1}), -0.165, 0.165);
  double before = 0.0;
  // The frustum's upper edge of the ice is met first, at x = 6.8 + 0.165 / tan(angle).
  const double first = -0.165 / std::tan(radians(61.4));
  const Vec3 normal{std::sin(radians(61.4)), 0, -std::cos(radians(61.4))};
  for (int i = 0; i <= 400; ++i) {
    const double shift = first - 0.01 + 0.0005 * i;
    const double area = overlap_area(placed(ice, {}), placed(frustum, {{shift, 0, 0}, {}}), normal);
    if (shift <= first) BOOST_TEST(area == 0.0);
    BOOST_TEST(area >= before);
    // A strip of 2 m at most grows by 2 m * 0.5 mm / cos(angle) a step, and while the flat facet (0.67 m wide) meets
    // the straight edge no faster.
    BOOST_TEST(area - before <= 2 * 0.0005 / std::cos(radians(61.4)) + 1e-12);
    before = area;
  }
  BOOST_TEST(before > 0.3);
}

BOOST_AUTO_TEST_CASE(A_part_inside_another_overlaps_with_all_of_itself) {
  const ConvexPart outer = cube();
  const ConvexPart inner = convex_prism(rectangle({-0.2, -0.1}, {0.2, 0.1}), -0.3, 0.3);
  BOOST_TEST(overlap_area(placed(inner, {}), placed(outer, {}), {0, 0, 1}) == 0.08,
             boost::test_tools::tolerance(kRoundOff));
  BOOST_TEST(overlap_area(placed(outer, {}), placed(inner, {}), {1, 0, 0}) == 0.12,
             boost::test_tools::tolerance(kRoundOff));
}

BOOST_AUTO_TEST_CASE(Parts_that_touch_in_a_face_do_not_overlap) {
  const ConvexPart box = cube();
  OverlapFinder finder;
  BOOST_TEST(finder.find(placed(box, {}), placed(box, {{2, 0.5, 0}, {}})).vertices.empty());
  BOOST_TEST(finder.find(placed(box, {}), placed(box, {{0, 0, 2 - 1e-10}, {}})).vertices.empty());
  BOOST_TEST(!finder.find(placed(box, {}), placed(box, {{2 - 1e-8, 0.5, 0}, {}})).vertices.empty());
}

BOOST_AUTO_TEST_CASE(Two_boxes_overlap_in_a_box_with_a_way_out_through_each_face) {
  const ConvexPart box = cube();
  OverlapFinder finder;
  const Overlap& overlap = finder.find(placed(box, {{1.5, 1.0, 0.2}, {}}), placed(box, {}));
  BOOST_TEST(overlap.axes.size() == 12u);
  const auto shortest =
      std::min_element(overlap.axes.begin(), overlap.axes.end(),
                       [](const SeparatingAxis& p, const SeparatingAxis& q) { return p.depth < q.depth; });
  BOOST_TEST(shortest->depth == 0.5, boost::test_tools::tolerance(kRoundOff));
  BOOST_TEST(norm(shortest->normal - Vec3{1, 0, 0}) == 0.0);
  BOOST_TEST(finder.project({1, 0, 0}).area == 1.0 * 1.8, boost::test_tools::tolerance(kRoundOff));
  BOOST_TEST(finder.project({1, 0, 0}).depth == 0.5, boost::test_tools::tolerance(kRoundOff));
}

BOOST_AUTO_TEST_CASE(The_points_shares_add_up_to_the_area_and_have_its_centroid) {
  // A prism over an irregular heptagon dipped into the ground: the projection is the heptagon.
  const std::vector<Vec2> ring{{0, 0}, {2, -0.5}, {3, 0.1}, {3.3, 1.2}, {2, 2.4}, {0.7, 2.2}, {-0.2, 1}};
  const ConvexPart prism = convex_prism(ring, -0.2, 0.2);
  const ConvexPart plane = ground();
  OverlapFinder finder;
  finder.find(placed(prism, {}), placed(plane, {}));
  const Patch patch = finder.project({0, 0, 1});
  double area = 0.0;
  Vec2 moment{};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 p = ring[i], q = ring[(i + 1) % ring.size()];
    area += cross(p, q) / 2;
    moment += cross(p, q) / 6 * (p + q);
  }
  BOOST_TEST(patch.n_points == 4);
  BOOST_TEST(patch.area == area, boost::test_tools::tolerance(kRoundOff));
  double sum = 0.0;
  Vec2 first{};
  for (int i = 0; i < patch.n_points; ++i) {
    BOOST_TEST(patch.points[i].area > 0.0);
    BOOST_TEST(patch.points[i].position.z == -0.1, boost::test_tools::tolerance(kRoundOff));
    sum += patch.points[i].area;
    first += patch.points[i].area * plan(patch.points[i].position);
  }
  BOOST_TEST(sum == area, boost::test_tools::tolerance(kRoundOff));
  BOOST_TEST(norm(first - moment) < kRoundOff);
}

BOOST_AUTO_TEST_CASE(A_narrow_strip_has_a_point_at_each_end) {
  const ConvexPart box = cube();
  const ConvexPart plane = ground();
  OverlapFinder finder;
  finder.find(placed(box, turned({0, 0, std::sqrt(2.0) - 0.01}, {1, 0, 0}, kPi / 4)), placed(plane, {}));
  const Patch patch = finder.project({0, 0, 1});
  BOOST_TEST(patch.n_points == 2);
  for (int i = 0; i < patch.n_points; ++i) {
    BOOST_TEST(std::abs(patch.points[i].position.x) == 1.0, boost::test_tools::tolerance(kRoundOff));
    BOOST_TEST(std::abs(patch.points[i].position.y) < kRoundOff);
    BOOST_TEST(patch.points[i].area == patch.area / 2, boost::test_tools::tolerance(kRoundOff));
  }
}

BOOST_AUTO_TEST_CASE(The_hull_of_a_frustum_has_a_face_for_each_facet_and_two_ends) {
  const ConvexPart frustum = convex_hull(cone(6.8, radians(61.4), 5.68, 3.4));
  BOOST_TEST(frustum.planes.size() == 66u);
  BOOST_TEST(frustum.vertices.size() == 128u);
  std::size_t quads = 0;
  for (const auto& face : frustum.faces) quads += face.size() == 4;
  BOOST_TEST(quads == 64u);
  for (std::size_t f = 0; f < frustum.faces.size(); ++f) {
    const auto& loop = frustum.faces[f];
    const Vec3 p = frustum.vertices[loop[0]], q = frustum.vertices[loop[1]], r = frustum.vertices[loop[2]];
    BOOST_TEST(dot(cross(q - p, r - q), frustum.planes[f].normal) > 0);
  }
}

BOOST_AUTO_TEST_CASE(Points_inside_the_faces_of_a_hull_are_no_vertices) {
  // A box whose faces are split 4 x 4, turned by amounts that round off. Points halfway along its edges stay: they are
  // where faces meet.
  for (const Quaternion& turn : {Quaternion{}, turned({}, {0, 0, 1}, kPi / 2).rotation,
                                 turned({}, {1, 0, 0}, kPi / 4).rotation, turned({}, {3, -1, 2}, 0.7).rotation}) {
    std::vector<Vec3> points;
    for (int i = 0; i <= 4; ++i)
      for (int j = 0; j <= 4; ++j)
        for (int k = 0; k <= 4; ++k) points.push_back(rotate(turn, {2.0 * i, 1.5 * j, 1.5 * k}));
    const ConvexPart hull = convex_hull(points);
    BOOST_TEST(hull.planes.size() == 6u);
    BOOST_TEST(hull.vertices.size() == 8u + 12u * 3u);
    BOOST_TEST(hull.edges.size() == 12u * 4u);
    for (const auto& face : hull.faces) BOOST_TEST(face.size() == 16u);
    // Inside a larger body all of it overlaps: 8 m x 6 m along the box's z.
    const Quaternion back{turn.w, -turn.x, -turn.y, -turn.z};
    const ConvexPart room = convex_prism(rectangle({-50, -50}, {50, 50}), -50, 50);
    BOOST_TEST(overlap_area(placed(hull, {{}, back}), placed(room, {}), {0, 0, 1}) == 48.0,
               boost::test_tools::tolerance(kRoundOff));
  }
}

BOOST_AUTO_TEST_CASE(A_point_in_the_middle_of_a_face_changes_no_hull) {
  std::vector<Vec3> points = box({-1, -1, -1}, {1, 1, 1});
  const ConvexPart plain = convex_hull(points);
  for (const double x : {0.0, 0.5, -0.5}) points.insert(points.begin(), {x, 0.25 * x, 1.0});
  points.push_back({0.0, 0.999, 1.0});
  points.push_back({0.3, 0.2, 0.1});  // inside the solid
  const ConvexPart hull = convex_hull(points);
  BOOST_TEST((hull.vertices == plain.vertices));
  BOOST_TEST((hull.faces == plain.faces));
}

BOOST_AUTO_TEST_CASE(A_part_thinner_than_two_insets_has_no_inset) {
  const ConvexPart thin = convex_prism(rectangle({0, 0}, {1, 0.009}), -0.2, 0.2);
  BOOST_TEST(inset_vertices(thin, 0.005).empty());
  BOOST_TEST(inset_vertices(thin, 0.004).size() == 8u);
  BOOST_TEST(!outlasts_inset(thin, 0.005));
  BOOST_TEST(outlasts_inset(thin, 0.004));
}

BOOST_AUTO_TEST_CASE(A_part_whose_middle_is_not_deep_may_outlast_its_inset) {
  // Many points at the narrow end draw the middle of the vertices there.
  std::vector<Vec2> ring{{10, -1}, {10, 1}};
  for (int angle = 100; angle <= 260; angle += 10)
    ring.push_back({0.05 * std::cos(radians(angle)), 0.05 * std::sin(radians(angle))});
  const ConvexPart wedge = convex_prism(ring, -0.2, 0.2);
  BOOST_TEST(inset_vertices(wedge, 0.19).size() >= 6u);
  BOOST_TEST(outlasts_inset(wedge, 0.19));
  BOOST_TEST(!outlasts_inset(wedge, 0.2));
}
