// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "brash/geometry/ice_sheet.hpp"
#include "shapes.hpp"

using namespace brash;
using namespace brash::geometry;

namespace {

Ring box(double x0, double y0, double x1, double y1) {
  const Vec2 corners[] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  return ring(corners);
}

IceSheet sheet_of(std::vector<Polygon> polygons) {
  auto sheet = IceSheet::from_polygons(polygons);
  BOOST_REQUIRE_MESSAGE(sheet.has_value(), (sheet ? "" : sheet.error().what));
  return std::move(*sheet);
}

ExactArea total(const std::vector<Polygon>& polygons) {
  ExactArea sum;
  for (const Polygon& polygon : polygons) sum += area(polygon);
  return sum;
}

/// Checks that a cut loses nothing, to the last unit.
template <typename Take>
Cut check_cut(IceSheet& sheet, Take take) {
  const ExactArea before = sheet.area();
  Cut cut = take();
  BOOST_TEST((before == sheet.area() + total(cut.pieces) + cut.snap));
  sheet.check();
  return cut;
}

Cut cut_and_check(IceSheet& sheet, const Ring& region, std::vector<Crack> cracks = {}) {
  return check_cut(sheet, [&] { return sheet.cut(region, cracks); });
}

Cut crush_and_check(IceSheet& sheet, const Ring& region) {
  return check_cut(sheet, [&] { return sheet.crush(region); });
}

}  // namespace

BOOST_AUTO_TEST_SUITE(ice_sheet_cut)

BOOST_AUTO_TEST_CASE(a_sheet_keeps_the_exact_area_of_its_polygons_whatever_their_orientation) {
  Ring clockwise = box(0, 0, 50, 50);
  std::reverse(clockwise.begin(), clockwise.end());
  const IceSheet sheet = sheet_of({{clockwise, {box(10, 10, 12, 12)}}, {box(60, 0, 61, 1), {}}});
  BOOST_TEST(sheet.area().square_metres() == 2500.0 - 4.0 + 1.0);
  BOOST_TEST(sheet.n_vertices() == 12u);
  const std::vector<Polygon> polygons = sheet.polygons();
  BOOST_TEST_REQUIRE(polygons.size() == 2u);
  BOOST_TEST((polygons[0] ==
              Polygon{box(0, 0, 50, 50), {Ring{snap({10, 10}), snap({10, 12}), snap({12, 12}), snap({12, 10})}}}));
  BOOST_TEST(sheet.contains({5, 5}));
  BOOST_TEST(sheet.contains({0, 7}));
  BOOST_TEST(sheet.contains({12, 11}));
  BOOST_TEST(!sheet.contains({11, 11}));
  BOOST_TEST(!sheet.contains({55, 0.5}));
  BOOST_TEST(sheet.contains({60.5, 0.5}));
}

BOOST_AUTO_TEST_CASE(polygons_that_cross_overlap_or_nest_are_refused_with_the_place) {
  const std::vector<std::vector<Polygon>> wrong = {
      {{box(0, 0, 2, 2), {}}, {box(1, 1, 3, 3), {}}},
      {{box(0, 0, 4, 4), {}}, {box(1, 1, 3, 3), {}}},
      {{box(0, 0, 4, 4), {}}, {box(0, 0, 4, 4), {}}},
      {{box(0, 0, 4, 4), {box(5, 5, 6, 6)}}},
      {{ring(std::vector<Vec2>{{0, 0}, {2, 2}, {2, 0}, {0, 3}}), {}}},
      {{box(0, 0, 10, 10), {}}, {box(20, 0, 30, 10), {box(2, 2, 4, 4)}}},
  };
  for (const auto& polygons : wrong) {
    const auto sheet = IceSheet::from_polygons(polygons);
    BOOST_TEST_REQUIRE(!sheet.has_value());
    BOOST_TEST(sheet.error().what.find('(') != std::string::npos, sheet.error().what);
  }
  BOOST_TEST(IceSheet::from_polygons(wrong.back()).error().what == "polygon 1: there is no ice for a hole at (2, 2)");
  const std::vector<Polygon> thin = {{brash::geometry::shapes::units({{0, 0}, {1, 1}, {2, 2}}), {}}};
  BOOST_TEST(!IceSheet::from_polygons(thin).has_value());
}

BOOST_AUTO_TEST_CASE(a_square_bite_at_the_edge_leaves_a_notch_and_one_piece) {
  IceSheet sheet = sheet_of({{box(0, 0, 50, 50), {}}});
  const Cut cut = cut_and_check(sheet, box(20, -1, 22, 1));
  BOOST_TEST_REQUIRE(cut.pieces.size() == 1u);
  BOOST_TEST(area(cut.pieces[0]).square_metres() == 2.0);
  BOOST_TEST(sheet.area().square_metres() == 2498.0);
  BOOST_TEST(sheet.n_vertices() == 8u);
  BOOST_TEST((cut.snap == ExactArea{}));
}

BOOST_AUTO_TEST_CASE(a_disc_inside_the_ice_makes_a_hole_and_a_disc_outside_does_nothing) {
  IceSheet sheet = sheet_of({{box(0, 0, 50, 50), {}}});
  const Cut hole = cut_and_check(sheet, disc({25, 25}, 2.0, 32));
  BOOST_TEST_REQUIRE(hole.pieces.size() == 1u);
  BOOST_TEST((hole.pieces[0].outline.size() == 32u));
  BOOST_TEST_REQUIRE(sheet.polygons().size() == 1u);
  BOOST_TEST(sheet.polygons()[0].holes.size() == 1u);
  const Cut again = cut_and_check(sheet, disc({25, 25}, 2.0, 32));
  BOOST_TEST(again.pieces.empty());
  const Cut water = cut_and_check(sheet, disc({-25, 25}, 2.0, 32));
  BOOST_TEST(water.pieces.empty());
  BOOST_TEST(sheet.n_vertices() == 36u);
}

BOOST_AUTO_TEST_CASE(radial_cracks_divide_a_half_disc_into_equal_wedges) {
  IceSheet sheet = sheet_of({{box(0, 0, 50, 50), {}}});
  const ExactArea before = sheet.area();
  const Cut cut = cut_circumferential(sheet, {0, 25}, 2.0, 4, 32);
  BOOST_TEST((before == sheet.area() + total(cut.pieces) + cut.snap));
  BOOST_TEST_REQUIRE(cut.pieces.size() == 4u);
  // A half disc of 16 chords in four: each wedge is four triangles of r^2/2 sin(2 pi/32), up to the grid.
  for (const Polygon& piece : cut.pieces) {
    BOOST_TEST(area(piece).square_metres() == 4 * 2.0 * std::sin(2 * M_PI / 32), boost::test_tools::tolerance(1e-8));
  }
}

BOOST_AUTO_TEST_CASE(wedges_share_the_ice_that_the_arc_meets_at_a_corner_and_all_round) {
  IceSheet corner = sheet_of({{box(0, 0, 50, 50), {}}});
  const Cut quarter = cut_circumferential(corner, {0, 0}, 2.0, 3, 24);
  BOOST_TEST_REQUIRE(quarter.pieces.size() == 3u);
  // A quarter of 24 chords in three: two triangles each, up to the grid.
  for (const Polygon& piece : quarter.pieces) {
    BOOST_TEST(area(piece).square_metres() == 2 * 2.0 * std::sin(2 * M_PI / 24), boost::test_tools::tolerance(1e-8));
  }
  IceSheet round = sheet_of({{box(0, 0, 50, 50), {}}});
  const Cut all = cut_circumferential(round, {25, 25}, 2.0, 5, 20);
  BOOST_TEST_REQUIRE(all.pieces.size() == 5u);
  for (const Polygon& piece : all.pieces) {
    BOOST_TEST(area(piece).square_metres() == 4 * 2.0 * std::sin(2 * M_PI / 20), boost::test_tools::tolerance(1e-8));
  }
  const double angles[] = {0.3, -0.4};
  const Cut given = cut_circumferential(round, {0, 25}, 1.0, angles, 16);
  BOOST_TEST(given.pieces.size() == 3u);
}

BOOST_AUTO_TEST_CASE(wedges_around_a_hole_are_as_many_as_asked_for) {
  // Inside the disc, around its centre, across its arc in two places of the turn, and of a sheet whose edge cuts the
  // disc.
  const std::vector<Ring> holes{box(24, 24, 25, 25), box(19.5, 19.5, 20.5, 20.5), box(18, 14, 21, 18),
                                box(22, 18, 26, 21)};
  for (const Ring& hole : holes)
    for (int n = 1; n <= 6; ++n) {
      IceSheet sheet = sheet_of({{box(0, 0, 50, 50), {Ring(hole.rbegin(), hole.rend())}}});
      const ExactArea before = sheet.area();
      const Cut cut = cut_circumferential(sheet, {20, 20}, 4.0, n, 32);
      BOOST_TEST(cut.pieces.size() == static_cast<std::size_t>(n));
      BOOST_TEST((before == sheet.area() + total(cut.pieces) + cut.snap));
    }
  for (int n = 1; n <= 6; ++n) {
    IceSheet sheet = sheet_of({{box(0, 0, 50, 50), {}}});
    BOOST_TEST(cut_circumferential(sheet, {2, 25}, 4.0, n, 32).pieces.size() == static_cast<std::size_t>(n));
    // On the edge itself, or so near that only rounding parts them.
    BOOST_TEST(cut_circumferential(sheet, {1e-9, 10}, 4.0, n, 32).pieces.size() == static_cast<std::size_t>(n));
  }
  // The gap's crack takes the middle between two wedges, so that no piece is twice as large as another.
  IceSheet sheet = sheet_of({{box(0, 0, 50, 50), {}}});
  std::vector<double> areas;
  for (const Polygon& piece : cut_circumferential(sheet, {2, 25}, 4.0, 4, 64).pieces)
    areas.push_back(area(piece).square_metres());
  BOOST_TEST(*std::max_element(areas.begin(), areas.end()) < 1.5 * *std::min_element(areas.begin(), areas.end()));
}

BOOST_AUTO_TEST_CASE(ice_that_does_not_reach_the_circle_is_divided_over_its_own_angles) {
  // The ice lies between -45 and 45 degrees; two cracks at +-15 degrees divide it.
  IceSheet ahead = sheet_of({{box(1, -1, 3, 1), {}}});
  const Cut cut = cut_circumferential(ahead, {0, 0}, 10.0, 3, 16);
  BOOST_TEST_REQUIRE(cut.pieces.size() == 3u);
  std::vector<double> areas;
  for (const Polygon& piece : cut.pieces) areas.push_back(area(piece).square_metres());
  std::sort(areas.begin(), areas.end());
  BOOST_TEST(std::abs(areas[2] - 8.0 * std::tan(kPi / 12.0)) < 1e-8);  // vertices are rounded to 1e-9 m
  BOOST_TEST(std::abs(areas[0] - areas[1]) < 1e-8);

  IceSheet around = sheet_of({{box(-1, -1, 3, 1), {}}});
  BOOST_TEST(cut_circumferential(around, {0, 0}, 10.0, 4, 16).pieces.size() == 4u);
  // A part behind another one adds no angle.
  IceSheet two = sheet_of({{box(1, -1, 3, 1), {}}, {box(4, -1, 5, 1), {}}});
  BOOST_TEST(cut_circumferential(two, {0, 0}, 10.0, 3, 16).pieces.size() == 4u);
}

BOOST_AUTO_TEST_CASE(cracks_that_split_nothing_leave_no_trace) {
  IceSheet sheet = sheet_of({{box(0, 0, 50, 50), {}}});
  const Crack cracks[] = {
      {snap({1, 10}), snap({1, 10.5})}, {snap({0, 10.1}), snap({1, 10.6})}, {snap({-5, 3}), snap({60, 7})}};
  const Cut cut = sheet.cut(box(-1, 9, 2, 11), cracks);
  BOOST_TEST_REQUIRE(cut.pieces.size() == 1u);
  BOOST_TEST((cut.pieces[0].outline == box(0, 9, 2, 11)));
}

BOOST_AUTO_TEST_CASE(a_cut_across_the_sheet_detaches_the_smaller_part_with_its_hole) {
  IceSheet sheet = sheet_of({{box(0, 0, 50, 10), {box(45, 4, 46, 5)}}});
  cut_and_check(sheet, box(40, -1, 41, 11));
  BOOST_TEST(sheet.polygons().size() == 2u);
  const std::vector<Polygon> detached = sheet.release_detached();
  BOOST_TEST_REQUIRE(detached.size() == 1u);
  BOOST_TEST(area(detached[0]).square_metres() == 90.0 - 1.0);
  BOOST_TEST(detached[0].holes.size() == 1u);
  BOOST_TEST(sheet.area().square_metres() == 400.0);
  BOOST_TEST(sheet.release_detached().empty());
}

BOOST_AUTO_TEST_CASE(loose_parts_leave_the_sheet_and_its_only_part_stays) {
  IceSheet sheet = sheet_of({{box(0, 0, 50, 10), {box(45, 4, 46, 5)}}});
  const auto all = [](const Polygon&) { return true; };
  BOOST_TEST(sheet.release_if(all).empty());
  cut_and_check(sheet, box(40, -1, 41, 11));
  cut_and_check(sheet, box(20, -1, 21, 11));
  BOOST_TEST(sheet.n_parts() == 3u);
  const auto is_large = [](const Polygon& part) { return area(part).square_metres() > 100.0; };
  const std::vector<Polygon> large = sheet.release_if(is_large);
  BOOST_TEST_REQUIRE(large.size() == 2u);
  BOOST_TEST(area(large[0]).square_metres() == 200.0);
  BOOST_TEST(area(large[1]).square_metres() == 190.0);
  BOOST_TEST(sheet.n_parts() == 1u);
  BOOST_TEST(sheet.area().square_metres() == 90.0 - 1.0);
  BOOST_CHECK_NO_THROW(sheet.check());
}

BOOST_AUTO_TEST_CASE(a_cut_that_swallows_everything_leaves_an_empty_sheet) {
  IceSheet sheet = sheet_of({{box(0, 0, 5, 5), {box(1, 1, 2, 2)}}});
  const Cut cut = cut_and_check(sheet, disc({2, 2}, 30.0, 16));
  BOOST_TEST_REQUIRE(cut.pieces.size() == 1u);
  BOOST_TEST(cut.pieces[0].holes.size() == 1u);
  BOOST_TEST(sheet.n_vertices() == 0u);
  BOOST_TEST((sheet.area() == ExactArea{}));
}

BOOST_AUTO_TEST_CASE(a_line_splits_a_floe_into_parts_that_tile_it) {
  const Polygon floe{disc({3, 4}, 2.0, 16), {}};
  const Cut cut = split(floe, snap({1, 4.3}), snap({5, 3.9}));
  BOOST_TEST(cut.pieces.size() == 2u);
  BOOST_TEST((area(floe) == total(cut.pieces) + cut.snap));
  const Cut beside = split(floe, snap({10, 0}), snap({10, 1}));
  BOOST_TEST_REQUIRE(beside.pieces.size() == 1u);
  BOOST_TEST((area(beside.pieces[0]) == area(floe)));
}

BOOST_AUTO_TEST_CASE(a_region_that_is_no_counter_clockwise_ring_is_a_broken_contract) {
  IceSheet sheet = sheet_of({{box(0, 0, 5, 5), {}}});
  Ring clockwise = box(1, 1, 2, 2);
  std::reverse(clockwise.begin(), clockwise.end());
  BOOST_CHECK_THROW(sheet.cut(clockwise), ContractViolation);
  BOOST_CHECK_THROW(sheet.cut(brash::geometry::shapes::units({{0, 0}, {1, 1}})), ContractViolation);
  const Vec2 crossed[] = {{1, 1}, {4, 1}, {2, 3}, {2, 0}, {3, 4}};
  BOOST_CHECK_THROW(sheet.cut(ring(crossed)), ContractViolation);
  BOOST_TEST(sheet.area().square_metres() == 25.0);
}

BOOST_AUTO_TEST_CASE(random_events_on_a_sheet_lose_nothing) {
  std::mt19937_64 random(7);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  for (int run = 0; run < 10; ++run) {
    IceSheet sheet = sheet_of({{box(0, 0, 20, 10), {}}});
    for (int i = 0; i < 60; ++i) {
      const ExactArea before = sheet.area();
      const Cut cut =
          cut_circumferential(sheet, {uniform(-1, 21), uniform(-1, 11)}, uniform(0.2, 1.5), 3 + i % 3, 8 + i % 20);
      BOOST_TEST_REQUIRE((before == sheet.area() + total(cut.pieces) + cut.snap));
      BOOST_TEST((cut.n_rounded > 0 || cut.snap == ExactArea{}));
      BOOST_CHECK_NO_THROW(sheet.check());
      const std::vector<Polygon> detached = sheet.release_detached();
      BOOST_TEST_REQUIRE((before == sheet.area() + total(cut.pieces) + cut.snap + total(detached)));
      BOOST_TEST_REQUIRE(sheet.polygons().size() <= 1u);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_region_that_moves_along_straight_sides_leaves_no_vertices_on_them) {
  IceSheet sheet = sheet_of({{box(0, -1, 10, 1), {}}});
  for (int i = 0; i < 300; ++i) crush_and_check(sheet, box(-1.0 + 0.01 * i, -0.9, 0.01 * (i + 1), 0.8));
  BOOST_TEST(sheet.n_vertices() == 8u);
  const Ring expected =
      ring(std::vector<Vec2>{{0, -1}, {10, -1}, {10, 1}, {0, 1}, {0, 0.8}, {3, 0.8}, {3, -0.9}, {0, -0.9}});
  const std::vector<Polygon> whole = sheet.polygons();
  BOOST_TEST((sheet.area() == signed_area(expected)));
  BOOST_TEST((whole == std::vector<Polygon>{Polygon{expected, {}}}));
}

BOOST_AUTO_TEST_CASE(a_region_that_moves_along_oblique_sides_leaves_few_vertices_on_them) {
  for (const double degrees : {7.0, 30.0, 45.0, 61.3}) {
    IceSheet sheet = sheet_of({{box(0, -5, 10, 20), {}}});
    const Vec2 along{std::cos(radians(degrees)), std::sin(radians(degrees))}, across{-along.y, along.x};
    ExactArea released, snap;
    for (int i = 0; i < 300; ++i) {
      const Vec2 front = (0.01 * i - 0.5) * along;
      const Vec2 corners[] = {front - 3.0 * along - across, front - across, front + across,
                              front - 3.0 * along + across};
      const Cut cut = crush_and_check(sheet, ring(corners));
      released += total(cut.pieces);
      snap += cut.snap;
    }
    BOOST_TEST(sheet.n_vertices() < 30u);
    BOOST_TEST(std::abs(snap.square_metres()) < 1e-7);
  }
}

BOOST_AUTO_TEST_SUITE_END()
