// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <set>

#include "brash/core/contract.hpp"
#include "brash/geometry/polygon.hpp"
#include "shapes.hpp"

namespace brash::geometry {
namespace {

using shapes::box;
using shapes::reversed;
using shapes::units;

/// Convex, positive, from the polygon's own vertices, with the polygon's exact area; and disjoint, which the exact area
/// of all pairwise clips would show: here that no part's centroid lies inside another.
void check_parts(const Polygon& polygon, std::size_t at_most) {
  const std::vector<Ring> parts = convex_parts(polygon);
  std::set<Point> vertices(polygon.outline.begin(), polygon.outline.end());
  for (const Ring& hole : polygon.holes) vertices.insert(hole.begin(), hole.end());
  ExactArea sum;
  for (const Ring& part : parts) {
    BOOST_TEST(is_convex(part));
    BOOST_TEST((signed_area(part) > ExactArea{}));
    for (const Point p : part) BOOST_TEST(vertices.contains(p));
    sum += signed_area(part);
  }
  BOOST_TEST((sum == area(polygon)));
  BOOST_TEST(parts.size() <= at_most);
}

BOOST_AUTO_TEST_SUITE(parts_of_polygons)

BOOST_AUTO_TEST_CASE(a_convex_polygon_is_its_own_part) {
  const Polygon square{box(0, 0, 1, 1), {}};
  BOOST_TEST((convex_parts(square) == std::vector<Ring>{square.outline}));
}

BOOST_AUTO_TEST_CASE(an_l_has_two_parts) {
  check_parts({ring(std::vector<Vec2>{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}), {}}, 2);
}

BOOST_AUTO_TEST_CASE(straight_on_vertices_make_no_empty_parts) {
  check_parts(
      {ring(std::vector<Vec2>{
           {0, 0}, {1, 0}, {2, 0}, {2, 0.5}, {2, 1}, {1.5, 1}, {1, 1}, {1, 1.5}, {1, 2}, {0.5, 2}, {0, 2}, {0, 1}}),
       {}},
      3);
}

BOOST_AUTO_TEST_CASE(a_frame_is_cut_around_its_hole) { check_parts({box(0, 0, 4, 4), {reversed(box(1, 1, 3, 3))}}, 4); }

BOOST_AUTO_TEST_CASE(many_holes_in_rows_are_bridged) {
  Polygon grate{box(0, 0, 9, 9), {}};
  for (int i = 1; i < 9; i += 2) {
    for (int j = 1; j < 9; j += 2) grate.holes.push_back(reversed(box(i, j, i + 1, j + 1)));
  }
  check_parts(grate, 4 * 16 + 16);
}

BOOST_AUTO_TEST_CASE(parts_that_touch_in_a_vertex_are_separate) {
  // A figure of eight, entered at its waist and elsewhere.
  check_parts({units({{0, 0}, {4, 4}, {8, 0}, {8, 8}, {4, 4}, {0, 8}}), {}}, 2);
  check_parts({units({{4, 4}, {8, 0}, {8, 8}, {4, 4}, {0, 8}, {0, 0}}), {}}, 2);
}

BOOST_AUTO_TEST_CASE(a_hole_may_touch_the_outline_in_a_vertex_or_on_an_edge) {
  check_parts({units({{0, 0}, {4, 0}, {8, 0}, {8, 8}, {0, 8}}), {units({{4, 0}, {2, 4}, {6, 4}})}}, 4);
  check_parts({units({{0, 0}, {8, 0}, {8, 8}, {0, 8}}), {units({{4, 0}, {2, 4}, {6, 4}})}}, 4);
  // The same shape as one loop that touches itself.
  check_parts({units({{0, 0}, {4, 0}, {2, 4}, {6, 4}, {4, 0}, {8, 0}, {8, 8}, {0, 8}}), {}}, 5);
}

BOOST_AUTO_TEST_CASE(a_hole_that_touches_the_outline_twice_splits_the_region) {
  check_parts({units({{0, 0}, {8, 0}, {8, 8}, {0, 8}}), {units({{4, 0}, {3, 4}, {4, 8}, {5, 4}})}}, 4);
}

BOOST_AUTO_TEST_CASE(holes_may_touch_each_other) {
  check_parts({units({{0, 0}, {9, 0}, {9, 9}, {0, 9}}),
               {units({{1, 1}, {1, 4}, {4, 4}, {4, 1}}), units({{4, 4}, {4, 7}, {7, 7}, {7, 4}})}},
              8);
}

BOOST_AUTO_TEST_CASE(an_outline_with_its_hole_already_bridged_is_read_as_one_with_a_hole) {
  check_parts({units({{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 0}, {2, 2}, {2, 6}, {6, 6}, {6, 2}, {2, 2}}), {}}, 5);
}

BOOST_AUTO_TEST_CASE(needles_of_one_unit_keep_their_area) {
  constexpr std::int64_t kMetre = 1LL << 30;
  check_parts({units({{0, 0}, {5 * kMetre, 0}, {5 * kMetre, 5 * kMetre}, {1, 1}}), {}}, 2);
  check_parts({units({{0, 0}, {kMetre, 1}, {2 * kMetre, 0}, {2 * kMetre, kMetre}, {kMetre, 2}, {0, kMetre}}), {}}, 4);
}

BOOST_AUTO_TEST_CASE(a_polygon_that_crosses_itself_is_a_broken_contract) {
  BOOST_CHECK_THROW(convex_parts({units({{0, 0}, {4, 4}, {4, 0}, {0, 4}}), {}}), ContractViolation);
}

BOOST_AUTO_TEST_CASE(random_stars_wedges_and_holed_stars_keep_their_area) {
  std::mt19937_64 generator(1);
  for (int i = 0; i < 500; ++i) {
    const int n = 3 + i % 40;
    check_parts({shapes::star(generator, n, 0.05 + 0.9 * shapes::uniform(generator)), {}}, n);
    check_parts({shapes::wedge(generator), {}}, 10);
    Polygon holed{disc({0, 0}, 3.0, 8 + i % 20), {}};
    holed.holes.push_back(reversed(shapes::star(generator, 5 + i % 9, 0.2, {1.2, 0.3})));
    holed.holes.push_back(reversed(shapes::star(generator, 5 + i % 7, 0.2, {-1.2, -0.3})));
    check_parts(holed, 60);
  }
}

BOOST_AUTO_TEST_CASE(parts_around_a_hole_are_the_same_whatever_was_divided_before) {
  std::mt19937_64 generator(3);
  for (int i = 0; i < 100; ++i) {
    Polygon holed{disc({0, 0}, 3.0, 8 + i % 20), {}};
    holed.holes.push_back(reversed(shapes::star(generator, 5 + i % 9, 0.2, {1.2, 0.3})));
    const std::vector<Ring> parts = convex_parts(holed);
    (void)convex_parts({shapes::star(generator, 30, 0.2), {}});
    BOOST_TEST((convex_parts(holed) == parts));
  }
}

BOOST_AUTO_TEST_CASE(coarse_random_polygons_with_many_coincidences_keep_their_area) {
  // Few units across: collinear and touching vertices in most of them. A union of cells of a checkerboard-like set,
  // given as its directed edges, needs no construction: each cell's hole is listed.
  std::mt19937_64 generator(2);
  for (int i = 0; i < 300; ++i) {
    Polygon sieve{units({{0, 0}, {12, 0}, {12, 12}, {0, 12}}), {}};
    for (std::int64_t x = 1; x < 11; x += 2) {
      for (std::int64_t y = 1; y < 11; y += 2) {
        if (generator() % 3 == 0) continue;
        // Diamonds of width 2: neighbours touch in vertices.
        sieve.holes.push_back(units({{x, y - 1}, {x - 1, y}, {x, y + 1}, {x + 1, y}}));
      }
    }
    check_parts(sieve, 150);
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(insets)

BOOST_AUTO_TEST_CASE(a_square_loses_the_distance_on_every_side) {
  const std::vector<Vec2> inner = inset(box(1, 1, 3, 3), 0.25);
  BOOST_REQUIRE(inner.size() == 4u);
  for (const Vec2 v : inner) BOOST_TEST(std::max(std::abs(v.x - 2), std::abs(v.y - 2)) == 0.75);
}

BOOST_AUTO_TEST_CASE(nothing_is_left_of_a_square_that_is_thinner_than_two_insets) {
  BOOST_TEST(inset(box(0, 0, 5, 1), 0.51).empty());
  BOOST_TEST(inset(box(0, 0, 5, 1), 0.5).empty());
}

BOOST_AUTO_TEST_CASE(a_short_side_may_vanish) {
  // The corner of the unit square cut by 0.01: its side is gone 0.1 further in.
  const Ring cut = ring(std::vector<Vec2>{{0, 0}, {0.99, 0}, {1, 0.01}, {1, 1}, {0, 1}});
  BOOST_TEST(inset(cut, 0.001).size() == 5u);
  BOOST_TEST(inset(cut, 0.1).size() == 4u);
}

BOOST_AUTO_TEST_CASE(insets_of_random_convex_parts_are_convex_and_keep_their_distance) {
  std::mt19937_64 generator(3);
  for (int i = 0; i < 300; ++i) {
    for (const Ring& part : convex_parts({shapes::wedge(generator), {}})) {
      const double distance = 0.02 * shapes::uniform(generator);
      const std::vector<Vec2> inner = inset(part, distance);
      for (std::size_t k = 0; k < inner.size(); ++k) {
        const Vec2 a = inner[k], b = inner[(k + 1) % inner.size()], c = inner[(k + 2) % inner.size()];
        BOOST_TEST(cross(b - a, c - b) > -1e-15);
        for (std::size_t s = 0; s < part.size(); ++s) {
          const Vec2 p = metres(part[s]), q = metres(part[(s + 1) % part.size()]);
          // A few roundings of coordinates of order 2 m, and vertices within a grid unit of each other are one.
          BOOST_TEST(cross(normalized(q - p), a - p) > distance - 2 * kGridUnit);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace brash::geometry
