// SPDX-License-Identifier: GPL-3.0-or-later
// Repairs with known areas, and random ones that places check.
#include "brash/geometry/repair.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "brash/geometry/text.hpp"
#include "shapes.hpp"

namespace brash::geometry {
namespace {

using shapes::box;
using shapes::in_text;
using shapes::reversed;

/// The repair of polygons, after the promises that every repair keeps.
Repair repaired(const std::vector<Polygon>& polygons) {
  const auto result = repair(polygons);
  BOOST_REQUIRE(result.has_value());
  BOOST_TEST(result->closes());
  std::vector<Polygon> parts;
  for (const Repair::Part& part : result->parts) parts.push_back(part.polygon);
  const auto sheet = IceSheet::from_polygons(parts);
  BOOST_REQUIRE(sheet.has_value());
  BOOST_TEST(sheet->area().to_string() == result->kept.to_string());
  BOOST_TEST(faults_of(parts).empty());
  BOOST_TEST(std::ranges::is_sorted(result->parts, {}, &Repair::Part::from));
  return *result;
}

ExactArea area_of(const Repair& repair, std::size_t from) {
  ExactArea sum;
  for (const Repair::Part& part : repair.parts)
    if (part.from == from) sum += area(part.polygon);
  return sum;
}

BOOST_AUTO_TEST_SUITE(repair_)

BOOST_AUTO_TEST_CASE(polygons_without_faults_stay_as_they_are) {
  const std::vector<Polygon> given{
      {box(0, 0, 4, 2), {}}, {box(4, 0, 6, 2), {}}, {ring(std::vector<Vec2>{{9, 9}, {7, 7}, {9, 7}}), {}}};
  const Repair found = repaired(given);
  BOOST_TEST(found.changed.empty());
  BOOST_TEST(found.faults.empty());
  for (std::size_t i = 0; i < given.size(); ++i) BOOST_TEST((found.parts[i].polygon == given[i]));
}

BOOST_AUTO_TEST_CASE(an_overlap_goes_to_the_first_polygon) {
  const Repair found = repaired({{box(0, 0, 4, 2), {}}, {box(3, 0, 6, 2), {}}, {box(10, 0, 11, 1), {}}});
  BOOST_TEST(area_of(found, 0).to_string() == "8");
  BOOST_TEST(area_of(found, 1).to_string() == "4");
  BOOST_TEST(found.overlap.to_string() == "2");
  BOOST_TEST(found.snap.to_string() == "0");
  BOOST_TEST((found.changed == std::vector<std::size_t>{1}));
  BOOST_REQUIRE(found.faults.size() == 1u);
  BOOST_TEST(found.faults[0].what.starts_with("polygon 0 overlaps polygon 1 at (3, 0)"), found.faults[0].what);
}

BOOST_AUTO_TEST_CASE(a_polygon_in_another_one_makes_a_hole_or_vanishes_and_a_repeated_one_vanishes) {
  const Polygon large{box(0, 0, 9, 9), {}}, small{box(2, 2, 3, 3), {}};
  const Repair hole = repaired({small, large});
  BOOST_TEST(area_of(hole, 1).to_string() == "80");
  BOOST_REQUIRE(hole.parts.size() == 2u);
  BOOST_TEST(hole.parts[1].polygon.holes.size() == 1u);
  const Repair gone = repaired({large, small, large});
  BOOST_TEST((gone.gone == std::vector<std::size_t>{1, 2}));
  BOOST_TEST(gone.kept.to_string() == "81");
  BOOST_TEST(gone.overlap.to_string() == "82");
}

BOOST_AUTO_TEST_CASE(both_lobes_of_a_bow_stay_also_where_their_areas_cancel) {
  const Repair equal = repaired(in_text("POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))"));
  BOOST_TEST(equal.parts.size() == 2u);
  BOOST_TEST(equal.kept.to_string() == "2");
  BOOST_TEST(equal.given.to_string() == "0");
  BOOST_TEST(equal.folded.to_string() == "-2");
  BOOST_TEST(equal.faults.at(0).what == "polygon 0 crosses itself at (1, 1)");
  // A loop that is wound twice counts once.
  const Repair loop = repaired(in_text("POLYGON ((0 0, 6 0, 6 6, 2 6, 2 2, 4 2, 4 8, 0 8, 0 0))"));
  BOOST_TEST(loop.kept.to_string() == "44");
  BOOST_TEST(loop.folded.to_string() == "8");
}

BOOST_AUTO_TEST_CASE(holes_take_away_what_lies_in_their_polygon_and_nothing_else) {
  const Polygon frame{box(0, 0, 9, 9), {}};
  const auto kept = [&](std::vector<Ring> holes) {
    for (Ring& hole : holes) hole = reversed(hole);
    return repaired({{frame.outline, holes}}).kept.to_string();
  };
  BOOST_TEST(kept({box(8, 1, 10, 3)}) == "79");                  // across the outline
  BOOST_TEST(kept({box(20, 1, 22, 3)}) == "81");                 // outside
  BOOST_TEST(kept({box(1, 1, 3, 3), box(2, 2, 4, 4)}) == "74");  // two that overlap
  BOOST_TEST(kept({box(1, 1, 3, 3), box(1, 1, 3, 3)}) == "77");  // twice
  BOOST_TEST(kept({box(-1, -1, 10, 10)}) == "0");                // around all of it
}

BOOST_AUTO_TEST_CASE(every_fault_is_listed_by_itself_or_by_its_pair) {
  const std::vector<Polygon> given = in_text(
      "POLYGON ((0 0, 3 2, 3 0, 0 1, 0 0)) POLYGON ((10 0, 14 0, 14 4, 10 4, 10 0)) "
      "POLYGON ((11 1, 12 1, 12 2, 11 2, 11 1)) POLYGON ((13 3, 15 3, 15 5, 13 5, 13 3)) "
      "POLYGON ((20 0, 21 0, 21 1, 20 1, 20 0), (30 0, 31 0, 31 1, 30 1, 30 0))");
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const Fault& fault : faults_of(given)) pairs.emplace_back(fault.first, fault.second);
  BOOST_TEST((pairs == std::vector<std::pair<std::size_t, std::size_t>>{{0, 0}, {4, 4}, {1, 3}, {1, 2}}));
  const std::string told = IceSheet::from_polygons(given).error().what;
  for (const char* part :
       {"polygon 0 crosses itself at (", "polygon 4: there is no ice for a hole at (30, 0)",
        "polygon 1 crosses polygon 3 at (13, 4), (14, 3)", "polygon 1 overlaps polygon 2 at (11, 1)"})
    BOOST_TEST(told.find(part) != std::string::npos, told);
  repaired(given);
}

BOOST_AUTO_TEST_CASE(random_polygons_give_every_place_to_the_first_that_holds_it) {
  std::mt19937_64 generator(19);
  for (int n = 2; n <= 40; n += 2) {
    const std::vector<Polygon> polygons = shapes::scattered(generator, n);
    std::vector<IceSheet> each;
    for (const Polygon& polygon : polygons) each.push_back(checked_sheet({&polygon, 1}));
    const Repair found = repaired(polygons);
    std::vector<IceSheet> parts;
    for (const Repair::Part& part : found.parts) parts.push_back(checked_sheet(std::span(&part.polygon, 1)));
    for (int k = 0; k < 200; ++k) {
      const Vec2 place{8.0 * shapes::uniform(generator) - 1.0, 8.0 * shapes::uniform(generator) - 1.0};
      const auto holds = [&](const IceSheet& ice) { return ice.contains(place); };
      const auto first = std::ranges::find_if(each, holds) - each.begin();
      const auto part = std::ranges::find_if(parts, holds) - parts.begin();
      const auto owner =
          part == std::ssize(parts) ? std::ssize(each) : static_cast<std::ptrdiff_t>(found.parts[part].from);
      BOOST_TEST(owner == first);
    }
    BOOST_TEST(std::abs(found.snap.square_metres()) < 1e-6);
  }
}

BOOST_AUTO_TEST_CASE(random_outlines_that_cross_themselves_are_repaired) {
  std::mt19937_64 generator(20);
  for (int i = 0; i < 200; ++i) {
    std::vector<Vec2> vertices;
    for (int k = 0; k < 4 + i % 12; ++k)
      vertices.push_back({4.0 * shapes::uniform(generator), 4.0 * shapes::uniform(generator)});
    const Repair found = repaired({{ring(vertices), {}}});
    BOOST_TEST(found.kept.square_metres() > 0.0);
    BOOST_TEST(found.overlap.to_string() == "0");
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace brash::geometry
