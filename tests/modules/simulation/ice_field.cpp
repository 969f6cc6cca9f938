// SPDX-License-Identifier: GPL-3.0-or-later
#include "ice_field.hpp"

#include <boost/test/unit_test.hpp>

#include "brash/core/constants.hpp"

namespace {

using namespace brash;
using simulation::IceField;

const std::vector<geometry::Ring> kFarAway{geometry::disc({-100.0, 0.0}, 1.0, 8)};

geometry::ExactArea total(const std::vector<geometry::Polygon>& polygons) {
  geometry::ExactArea sum;
  for (const auto& polygon : polygons) sum += geometry::area(polygon);
  return sum;
}

BOOST_AUTO_TEST_CASE(breaking_moves_area_from_the_sheet_to_the_floes_exactly) {
  IceField field(50.0, 50.0);
  const auto [floes, changed] = field.break_free({0.0, 1.0}, 3.0, 4, 16, kFarAway, 0.01);
  BOOST_TEST(floes.size() == 4u);
  BOOST_TEST(field.ledger().closes());
  BOOST_TEST((field.ledger().floes == total(floes)));
  BOOST_TEST((field.ledger().sheet == field.sheet().area()));
  // Half of a 16-gon inscribed in the circle.
  BOOST_TEST(field.ledger().floes.square_metres() == 0.5 * 8.0 * 9.0 * std::sin(kPi / 8.0),
             boost::test_tools::tolerance(1e-8));  // vertices are rounded to 1e-9 m
}

BOOST_AUTO_TEST_CASE(no_floe_is_born_inside_the_structure) {
  IceField field(50.0, 50.0);
  const geometry::Ring section = geometry::disc({-6.0, 0.0}, 6.8, 64);
  for (const geometry::Polygon& floe : field.break_free({0.0, 0.0}, 3.0, 5, 16, std::span(&section, 1), 0.01).floes) {
    auto ice = geometry::IceSheet::from_polygons(std::span(&floe, 1));
    BOOST_REQUIRE(ice.has_value());
    BOOST_TEST(ice->cut(section).pieces.empty());
  }
  BOOST_TEST(field.ledger().crushed.square_metres() > 0.0);
  BOOST_TEST(field.ledger().closes());
}

BOOST_AUTO_TEST_CASE(small_pieces_become_brash_and_stay_in_the_ledger) {
  IceField field(50.0, 50.0);
  const auto [floes, changed] = field.break_free({0.0, 0.0}, 0.5, 5, 16, kFarAway, 1.0);
  BOOST_TEST(floes.empty());
  BOOST_TEST(field.ledger().brash.square_metres() > 0.3);
  BOOST_TEST(field.ledger().closes());
}

BOOST_AUTO_TEST_CASE(crushed_ice_and_deleted_floes_stay_in_the_ledger) {
  IceField field(50.0, 50.0);
  const geometry::Extent crushed = field.crush(geometry::disc({0.0, 10.0}, 1.0, 16));
  // Half of a 16-gon; the front edge that it cuts is another from corner to corner.
  BOOST_TEST(field.ledger().crushed.square_metres() == 4.0 * std::sin(kPi / 8.0), boost::test_tools::tolerance(1e-8));
  BOOST_TEST(crushed.lower.y == -25.0);
  BOOST_TEST(crushed.upper.y == 25.0);
  BOOST_TEST(field.crush(geometry::disc({-5.0, 0.0}, 1.0, 16)).is_empty());
  const auto [floes, changed] = field.break_free({0.0, -10.0}, 2.0, 3, 16, kFarAway, 0.01);
  field.floe_to_deleted(geometry::area(floes.at(0)));
  field.floe_to_brash(geometry::area(floes.at(1)));
  BOOST_TEST((field.ledger().floes == geometry::area(floes.at(2))));
  BOOST_TEST(field.ledger().closes());
}

BOOST_AUTO_TEST_CASE(ice_cut_off_from_the_sheet_becomes_a_floe) {
  IceField strip(10.0, 4.0);
  // The disc is wider than the strip: what lies before it loses its hold, what lies behind stays the sheet.
  const auto [floes, changed] = strip.break_free({4.0, 0.0}, 2.5, 1, 16, kFarAway, 0.01);
  BOOST_TEST(floes.size() == 2u);
  BOOST_TEST(changed.lower.x == 0.0);  // the part that was cut off reaches to the edge
  BOOST_TEST(strip.sheet().polygons().size() == 1u);
  BOOST_TEST(strip.sheet().contains({9.0, 0.0}));
  BOOST_TEST(!strip.sheet().contains({0.5, 0.0}));
  BOOST_TEST(strip.ledger().closes());
}

}  // namespace
