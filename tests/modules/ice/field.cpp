// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/ice/field.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "level_ice.hpp"

namespace {

using namespace brash;
using namespace brash::ice;
using namespace brash::ice::testing;

/// Breaks a circle off the first level ice.
Broken break_circle(Field& field, Vec2 at, double radius, int n_wedges,
                    const std::vector<geometry::Ring>& structure = kFarAway, double smallest_floe = 0.01) {
  Plate& plate = field.level_ice(0);
  return field.break_off(plate, circle(plate, at, radius, n_wedges), structure, smallest_floe);
}

BOOST_AUTO_TEST_SUITE(fields)

BOOST_AUTO_TEST_CASE(breaking_moves_area_from_the_sheet_to_the_floes_exactly) {
  Field field = level_ice(50.0, 50.0);
  const Broken broken = break_circle(field, {0.0, 1.0}, 3.0, 4);
  BOOST_TEST(broken.pieces.size() == 4u);
  BOOST_TEST(field.ledger().closes());
  BOOST_TEST((field.ledger().floes == total(broken.pieces)));
  BOOST_TEST((field.ledger().sheet == field.level_ice()[0].area()));
  // Half of a 16-gon inscribed in the circle.
  BOOST_TEST(field.ledger().floes.square_metres() == 0.5 * 8.0 * 9.0 * std::sin(kPi / 8.0),
             boost::test_tools::tolerance(1e-8));  // vertices are rounded to 1e-9 m
}

BOOST_AUTO_TEST_CASE(no_floe_is_born_inside_the_structure) {
  Field field = level_ice(50.0, 50.0);
  const geometry::Ring section = geometry::disc({-6.0, 0.0}, 6.8, 64);
  for (Plate& piece : break_circle(field, {0.0, 0.0}, 3.0, 5, {section}).pieces)
    BOOST_TEST(piece.sheet().cut(section).pieces.empty());
  BOOST_TEST(field.ledger().crushed.square_metres() > 0.0);
  BOOST_TEST(field.ledger().closes());
}

BOOST_AUTO_TEST_CASE(small_pieces_become_brash_and_stay_in_the_ledger) {
  Field field = level_ice(50.0, 50.0);
  BOOST_TEST(break_circle(field, {0.0, 0.0}, 0.5, 5, kFarAway, 1.0).pieces.empty());
  BOOST_TEST(field.ledger().brash.square_metres() > 0.3);
  BOOST_TEST(field.ledger().closes());
}

BOOST_AUTO_TEST_CASE(crushed_ice_and_deleted_floes_stay_in_the_ledger) {
  Field field = level_ice(50.0, 50.0);
  const geometry::Extent crushed = field.crush(field.level_ice(0), geometry::disc({0.0, 10.0}, 1.0, 16));
  // Half of a 16-gon; the front edge that it cuts is another from corner to corner.
  BOOST_TEST(field.ledger().crushed.square_metres() == 4.0 * std::sin(kPi / 8.0), boost::test_tools::tolerance(1e-8));
  BOOST_TEST(crushed.lower.y == -25.0);
  BOOST_TEST(crushed.upper.y == 25.0);
  BOOST_TEST(field.crush(field.level_ice(0), geometry::disc({-5.0, 0.0}, 1.0, 16)).is_empty());
  const Broken broken = break_circle(field, {0.0, -10.0}, 2.0, 3);
  field.to_deleted(broken.pieces.at(0));
  field.to_brash(broken.pieces.at(1));
  BOOST_TEST((field.ledger().floes == broken.pieces.at(2).area()));
  BOOST_TEST(field.ledger().closes());
}

/// A field whose level ice drifts.
Field drifting_ice(double length, double width) {
  model::FieldSection section;
  section.length = length;
  section.width = width;
  section.border = model::Border::kFree;
  return {section, properties()};
}

BOOST_AUTO_TEST_CASE(ice_cut_off_from_the_sheet_becomes_a_floe) {
  Field strip = drifting_ice(10.0, 4.0);
  // The disc is wider than the strip: the ice before it loses its connection, the ice behind it stays the sheet.
  const Broken broken = break_circle(strip, {4.0, 0.0}, 2.5, 1);
  BOOST_TEST(broken.pieces.size() == 2u);
  BOOST_TEST(broken.changed.lower.x == 0.0);  // the part that was cut off reaches to the edge
  const geometry::IceSheet& sheet = strip.level_ice()[0].sheet();
  BOOST_TEST(sheet.polygons().size() == 1u);
  BOOST_TEST(sheet.contains({9.0, 0.0}));
  BOOST_TEST(!sheet.contains({0.5, 0.0}));
  BOOST_TEST(strip.ledger().closes());
}

/// Crushes a channel of corners [m] into the first level ice.
void crush_channel(Field& field, std::initializer_list<Vec2> corners) {
  BOOST_TEST(!field.crush(field.level_ice(0), geometry::ring(std::vector<Vec2>(corners))).is_empty());
}

BOOST_AUTO_TEST_CASE(drifting_ice_that_crushing_severs_leaves_the_sheet) {
  Field field = drifting_ice(30.0, 20.0);
  BOOST_TEST(field.release_severed(field.level_ice(0), kFarAway, 0.01).changed.is_empty());
  crush_channel(field, {{-1, 2}, {31, 2}, {31, 4}, {-1, 4}});
  const Broken severed = field.release_severed(field.level_ice(0), kFarAway, 0.01);
  BOOST_REQUIRE(severed.pieces.size() == 1u);
  BOOST_TEST(severed.pieces[0].area().square_metres() == 30.0 * 6.0);
  BOOST_TEST(severed.changed.lower.y == 4.0);
  BOOST_TEST(field.level_ice(0).area().square_metres() == 30.0 * 12.0);
  BOOST_TEST(field.level_ice(0).sheet().n_parts() == 1u);
  BOOST_TEST((field.ledger().floes == severed.pieces[0].area()));
  BOOST_TEST(field.ledger().closes());
}

BOOST_AUTO_TEST_CASE(a_break_tells_where_ice_beyond_its_crack_has_lost_its_hold) {
  Field wide = drifting_ice(30.0, 20.0);
  BOOST_TEST(break_circle(wide, {0.0, 0.0}, 2.5, 1).severed.empty());
  Field strip = drifting_ice(30.0, 4.0);
  const Broken broken = break_circle(strip, {10.0, 0.0}, 2.5, 1);
  BOOST_TEST(broken.pieces.size() == 2u);
  BOOST_REQUIRE(broken.severed.size() == 1u);
  BOOST_TEST(broken.severed[0].lower.x == 0.0);
  BOOST_TEST(broken.severed[0].upper.x > 7.5);
  BOOST_TEST(broken.severed[0].upper.x < 10.0);
}

BOOST_AUTO_TEST_CASE(ice_that_crushing_severs_is_not_born_inside_the_structure) {
  Field field = drifting_ice(30.0, 20.0);
  crush_channel(field, {{-1, 2}, {31, 2}, {31, 4}, {-1, 4}});
  const std::vector<geometry::Ring> structure{
      geometry::ring(std::array<Vec2, 4>{Vec2{10, 3}, {14, 3}, {14, 5}, {10, 5}})};
  const Broken severed = field.release_severed(field.level_ice(0), structure, 0.01);
  BOOST_REQUIRE(severed.pieces.size() == 1u);
  BOOST_TEST(severed.pieces[0].area().square_metres() == 30.0 * 6.0 - 4.0);
  BOOST_TEST(field.ledger().closes());
}

BOOST_AUTO_TEST_CASE(fast_ice_in_two_parts_is_held_on_both_sides) {
  // A break and a crushed channel part a strip between the sides.
  Field strip = level_ice(10.0, 4.0);
  BOOST_TEST(break_circle(strip, {4.0, 0.0}, 2.5, 1).pieces.size() == 1u);
  BOOST_TEST(strip.level_ice(0).sheet().n_parts() == 2u);
  BOOST_TEST(strip.level_ice(0).sheet().contains({0.5, 0.0}));
  BOOST_TEST(strip.level_ice(0).sheet().contains({9.0, 0.0}));

  Field field = level_ice(30.0, 20.0);
  crush_channel(field, {{-1, 2}, {31, 2}, {31, 4}, {-1, 4}});
  BOOST_TEST(field.release_severed(field.level_ice(0), kFarAway, 0.01).pieces.empty());
  BOOST_TEST(field.level_ice(0).sheet().n_parts() == 2u);
  BOOST_TEST(field.ledger().sheet.square_metres() == 30.0 * 18.0);
  BOOST_TEST(field.ledger().closes());

  // A part that no border holds leaves later.
  BOOST_TEST(break_circle(field, {0.0, -5.0}, 2.0, 1).pieces.size() == 1u);
  crush_channel(field, {{-1, 5}, {6, 5}, {6, 3}, {7, 3}, {7, 6}, {-1, 6}});
  const Broken severed = field.release_severed(field.level_ice(0), kFarAway, 0.01);
  BOOST_REQUIRE(severed.pieces.size() == 1u);
  BOOST_TEST(severed.pieces[0].area().square_metres() == 6.0 * 1.0);
  BOOST_TEST(field.level_ice(0).sheet().n_parts() == 2u);
}

BOOST_AUTO_TEST_CASE(fast_ice_keeps_a_small_part_that_is_held_and_releases_a_large_one_that_is_not) {
  Field field = level_ice(30.0, 20.0);
  crush_channel(field, {{-1, -9.5}, {29.5, -9.5}, {29.5, 9.5}, {-1, 9.5}, {-1, 9}, {29, 9}, {29, -9}, {-1, -9}});
  const Broken severed = field.release_severed(field.level_ice(0), kFarAway, 0.01);
  BOOST_REQUIRE(severed.pieces.size() == 1u);
  BOOST_TEST(severed.pieces[0].area().square_metres() == 29.0 * 18.0);
  BOOST_TEST(field.level_ice(0).area().square_metres() == 30.0 * 20.0 - 29.5 * 19.0);
  BOOST_TEST(field.ledger().closes());
}

BOOST_AUTO_TEST_CASE(a_piece_breaks_again_and_the_ledger_closes) {
  Field field = level_ice(50.0, 50.0);
  Broken broken = break_circle(field, {0.0, 0.0}, 3.0, 1);
  BOOST_REQUIRE(broken.pieces.size() == 1u);
  Plate& floe = broken.pieces[0];
  const geometry::ExactArea before = field.ledger().floes + field.ledger().snap, sheet = field.ledger().sheet;
  const Broken again = field.break_off(floe, circle(floe, {0.0, 0.0}, 1.0, 3), kFarAway, 0.01);
  BOOST_TEST(again.pieces.size() == 3u);
  BOOST_TEST(floe.area().square_metres() > 0.0);
  BOOST_TEST((field.ledger().floes == total(again.pieces) + floe.area()));
  BOOST_TEST((field.ledger().floes + field.ledger().snap == before));
  BOOST_TEST((field.ledger().sheet == sheet));
  BOOST_TEST(field.ledger().closes());
}

BOOST_AUTO_TEST_CASE(a_floe_splits_along_a_line_and_the_ledger_closes) {
  Field field = level_ice(50.0, 50.0);
  Broken broken = break_circle(field, {0.0, 0.0}, 3.0, 1);
  BOOST_REQUIRE(broken.pieces.size() == 1u);
  const geometry::ExactArea before = field.ledger().floes + field.ledger().snap;
  const std::vector<Plate> halves = field.split(broken.pieces[0], {0.0, 0.0}, {1.0, 0.0}, 0.01);
  BOOST_REQUIRE(halves.size() == 2u);
  BOOST_TEST(halves[0].area().square_metres() == halves[1].area().square_metres(),
             boost::test_tools::tolerance(1e-8));  // vertices are rounded to 1e-9 m
  BOOST_TEST((halves[0].hold() == Hold::kAfloat));
  BOOST_TEST((field.ledger().floes == total(halves)));
  BOOST_TEST((field.ledger().floes + field.ledger().snap == before));
  const std::vector<Plate> large = field.split(halves[0], {0.1, -1.0}, {0.1, 1.0}, 1.0);
  BOOST_TEST(large.size() == 1u);
  BOOST_TEST((field.ledger().floes == large[0].area() + halves[1].area()));
  BOOST_TEST(field.ledger().brash.square_metres() > 0.2);
  BOOST_TEST(field.ledger().closes());
}

BOOST_AUTO_TEST_CASE(drifting_ice_splits_from_a_contact_to_the_far_border_and_the_ledger_closes) {
  Field field = drifting_ice(30.0, 20.0);
  // A channel that stops in the ice: the crack goes on from its end, and leaves the ice beside it whole.
  (void)field.crush(field.level_ice(0), geometry::ring(std::array<Vec2, 4>{Vec2{-1, 2}, {10, 2}, {10, 4}, {-1, 4}}));
  const geometry::ExactArea before = field.ledger().sheet;
  Broken broken = field.split_sheet(field.level_ice(0), {10.0, 3.0}, {1.0, 0.0}, 0.01);
  BOOST_TEST(broken.pieces.size() == 1u);
  // The upper part: 30 x 7 m beside the crack, less the channel's upper half.
  BOOST_TEST(broken.pieces[0].area().square_metres() == 30.0 * 7.0 - 10.0, boost::test_tools::tolerance(1e-8));
  BOOST_TEST((field.level_ice(0).area() + broken.pieces[0].area() + field.ledger().snap == before));
  BOOST_TEST(field.ledger().closes());

  BOOST_TEST(field.add_level_ice(std::move(broken.pieces[0])) == 1);
  BOOST_TEST(field.level_ice().size() == 2u);
  BOOST_TEST((field.ledger().floes == geometry::ExactArea{}));
  BOOST_TEST((field.ledger().sheet == field.level_ice(0).area() + field.level_ice(1).area()));

  // A crack that leaves the ice at once divides nothing.
  const geometry::ExactArea lower = field.level_ice(0).area();
  BOOST_TEST(field.split_sheet(field.level_ice(0), {0.0, -5.0}, {-1.0, 0.0}, 0.01).pieces.empty());
  BOOST_TEST((field.level_ice(0).area() == lower));

  const std::vector<Plate> floes = field.release(field.level_ice(1), 0.01);
  BOOST_TEST(floes.size() == 1u);
  BOOST_TEST(field.level_ice(1).outline().empty());
  BOOST_TEST((field.ledger().floes == floes[0].area()));
  BOOST_TEST(field.ledger().closes());
}

BOOST_AUTO_TEST_CASE(a_crack_through_a_large_sheet_stays_on_the_plane_of_the_ice) {
  Field field = drifting_ice(4000.0, 4000.0);
  crush_channel(field, {{-1, -1}, {3000, -1}, {3000, 1}, {-1, 1}});
  // The diagonal of the sheet would lead the crack beyond 8192 m.
  const Broken broken = field.split_sheet(field.level_ice(0), {3000.0, 0.0}, {1.0, 0.0}, 0.01);
  BOOST_REQUIRE(broken.pieces.size() == 1u);
  BOOST_TEST(broken.pieces[0].area().square_metres() == 4000.0 * 2000.0 - 3000.0);
  BOOST_TEST((field.level_ice(0).area() == broken.pieces[0].area()));
}

BOOST_AUTO_TEST_CASE(a_field_restores_what_it_saved) {
  Field field = level_ice(50.0, 50.0);
  (void)break_circle(field, {0.0, 0.0}, 3.0, 4);
  (void)field.crush(field.level_ice(0), geometry::disc({0.0, 10.0}, 1.0, 16));
  model::Checkpoint checkpoint;
  field.save(checkpoint);
  model::FieldSection section;
  section.length = section.width = 50.0;
  const Field restored(section, properties(), {}, checkpoint);
  BOOST_TEST((restored.outlines() == field.outlines()));
  BOOST_TEST((restored.ledger().crushed == field.ledger().crushed));
  BOOST_TEST(restored.ledger().n_rounded == field.ledger().n_rounded);
  // Accounts that do not fit the ice are refused.
  model::Table& ledger = checkpoint.table("ledger");
  std::swap(ledger.column("sheet").values, ledger.column("floes").values);
  BOOST_CHECK_THROW(Field(section, properties(), {}, checkpoint), ContractViolation);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
