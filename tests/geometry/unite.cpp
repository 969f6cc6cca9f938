// SPDX-License-Identifier: GPL-3.0-or-later
// Unions with known areas, and unions that cuts and places check.
#include "brash/geometry/unite.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "brash/geometry/text.hpp"
#include "shapes.hpp"

namespace brash::geometry {
namespace {

using shapes::box;
using shapes::in_text;
using shapes::reversed;

/// The union of polygons, after the promises that every union keeps.
Union united(const std::vector<Polygon>& polygons) {
  const auto result = unite(polygons);
  BOOST_REQUIRE(result.has_value());
  BOOST_TEST(result->closes());
  ExactArea sum;
  for (const Polygon& polygon : result->polygons) {
    BOOST_TEST(fault_of(polygon) == "");
    sum += area(polygon);
  }
  BOOST_TEST(sum.to_string() == result->united.to_string());
  const auto again = unite(result->polygons);
  BOOST_REQUIRE(again.has_value());
  BOOST_TEST((again->polygons == result->polygons));
  BOOST_TEST(again->overlap.to_string() == "0");
  return *result;
}

BOOST_AUTO_TEST_SUITE(unite_)

BOOST_AUTO_TEST_CASE(boxes_that_overlap_touch_and_repeat_have_known_areas) {
  const Polygon one{box(0, 0, 4, 2), {}};
  const Union crossed = united({one, {box(1, -1, 2, 5), {}}});
  BOOST_TEST(crossed.united.to_string() == "12");
  BOOST_TEST(crossed.overlap.to_string() == "2");
  BOOST_TEST(crossed.polygons.size() == 1u);
  const Union twice = united({one, one, one});
  BOOST_TEST(twice.united.to_string() == "8");
  BOOST_TEST(twice.overlap.to_string() == "16");
  BOOST_TEST((twice.polygons == std::vector{one}));
  const Union beside = united({one, {box(4, 0, 6, 2), {}}});
  BOOST_TEST(beside.polygons.size() == 1u);
  BOOST_TEST(beside.united.to_string() == "12");
  BOOST_TEST(beside.n_rounded == 0);
  const Union apart = united({one, {box(5, 0, 6, 2), {}}, {box(-1, -1, 0, 0), {}}});  // the last touches a corner
  BOOST_TEST(apart.polygons.size() == 3u);
  BOOST_TEST(united({}).polygons.empty());
}

BOOST_AUTO_TEST_CASE(holes_are_filled_by_what_lies_in_them_and_made_by_what_lies_around) {
  const Polygon frame{box(0, 0, 9, 9), {reversed(box(1, 1, 8, 8))}};
  const Union filled = united({frame, {box(1, 1, 8, 8), {}}});
  BOOST_TEST(filled.united.to_string() == "81");
  BOOST_TEST(filled.polygons.size() == 1u);
  const Union within = united({frame, {box(2, 2, 3, 3), {}}});
  BOOST_TEST(within.polygons.size() == 2u);
  BOOST_TEST(within.united.to_string() == "33");
  const Union ring =
      united({{box(0, 0, 9, 1), {}}, {box(8, 0, 9, 9), {}}, {box(0, 8, 9, 9), {}}, {box(0, 0, 1, 9), {}}});
  BOOST_REQUIRE(ring.polygons.size() == 1u);
  BOOST_TEST(ring.polygons[0].holes.size() == 1u);
  BOOST_TEST(ring.united.to_string() == "32");
  BOOST_TEST(ring.overlap.to_string() == "4");
}

BOOST_AUTO_TEST_CASE(a_crossing_off_the_grid_moves_an_area_that_the_ledger_counts) {
  const Union star = united(in_text("POLYGON ((0 0, 3 0, 0 3, 0 0)) POLYGON ((1 -1, 2 -1, 1 7, 1 -1))"));
  BOOST_TEST(star.n_rounded > 0);
  BOOST_TEST(std::abs(star.snap.square_metres()) < 1e-8);
}

BOOST_AUTO_TEST_CASE(a_polygon_that_is_not_simple_is_named) {
  const auto bad = unite(in_text("POLYGON ((0 0, 1 0, 0 1, 0 0)) POLYGON ((0 0, 3 2, 3 0, 0 1, 0 0))"));
  BOOST_REQUIRE(!bad);
  BOOST_TEST(bad.error().what.starts_with("polygon 1: crosses itself at (1, 0.6666"), bad.error().what);
}

BOOST_AUTO_TEST_CASE(two_random_polygons_overlap_as_a_cut_of_one_by_the_other_says) {
  std::mt19937_64 generator(17);
  for (int i = 0; i < 300; ++i) {
    const Polygon one{shapes::star(generator, 3 + i % 9, 0.2), {}};
    const Vec2 centre{2.0 * shapes::uniform(generator) - 1.0, 2.0 * shapes::uniform(generator) - 1.0};
    const Polygon other{shapes::star(generator, 3 + i % 7, 0.2, centre), {}};
    ExactArea common;
    for (const Polygon& part : checked_sheet(std::span(&one, 1)).within(other.outline)) common += area(part);
    const Union found = united({one, other});
    // Either way a crossing moves by less than a grid unit along edges of 2 m.
    BOOST_TEST(std::abs((found.overlap - common).square_metres()) < 1e-7, i);
  }
}

BOOST_AUTO_TEST_CASE(a_place_lies_in_the_union_of_many_polygons_where_it_lies_in_one_of_them) {
  std::mt19937_64 generator(18);
  for (int n = 2; n <= 40; n += 2) {
    const std::vector<Polygon> polygons = shapes::scattered(generator, n);
    std::vector<IceSheet> each;
    for (const Polygon& polygon : polygons) each.push_back(checked_sheet({&polygon, 1}));
    const IceSheet all = checked_sheet(united(polygons).polygons);
    for (int k = 0; k < 500; ++k) {
      const Vec2 place{8.0 * shapes::uniform(generator) - 1.0, 8.0 * shapes::uniform(generator) - 1.0};
      const bool is_in_one = std::ranges::any_of(each, [&](const IceSheet& ice) { return ice.contains(place); });
      BOOST_TEST(all.contains(place) == is_in_one);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace brash::geometry
