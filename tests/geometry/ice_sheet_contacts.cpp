// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "brash/core/contract.hpp"
#include "brash/geometry/ice_sheet.hpp"

using namespace brash;
using namespace brash::geometry;

namespace {

// Vertices are rounded to 2^-30 m = 0.93 nm; lengths here are of the order of a metre.
constexpr double kGridTolerance = 4e-9;

Ring box(double x0, double y0, double x1, double y1) {
  const Vec2 corners[] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  return ring(corners);
}

IceSheet sheet_of(const std::vector<Polygon>& polygons) { return std::move(IceSheet::from_polygons(polygons).value()); }

void expect_near(Vec2 a, Vec2 b) { BOOST_TEST(norm(a - b) < kGridTolerance, a.x << ", " << a.y); }

}  // namespace

BOOST_AUTO_TEST_SUITE(ice_sheet_contacts)

BOOST_AUTO_TEST_CASE(a_section_over_a_straight_edge_has_one_contact_with_its_chord_and_middle) {
  const IceSheet sheet = sheet_of({{box(0, 0, 50, 50), {}}});
  const auto contacts = sheet.contacts(box(-3, 20, 1, 24));
  BOOST_TEST_REQUIRE(contacts.size() == 1u);
  BOOST_TEST(area(contacts[0].overlap).square_metres() == 4.0);
  expect_near(contacts[0].chord_from, {0, 20});
  expect_near(contacts[0].chord_to, {0, 24});
  expect_near(contacts[0].midpoint, {0, 22});
  expect_near(contacts[0].normal, {1, 0});
  BOOST_TEST(contacts[0].contact_length == 4.0);
}

BOOST_AUTO_TEST_CASE(two_headlands_in_one_section_are_two_contacts_sorted_by_angle) {
  const Vec2 outline[] = {{0, 0}, {10, 0}, {10, 20}, {0, 20}, {0, 12}, {5, 12}, {5, 8}, {0, 8}};
  const IceSheet sheet = sheet_of({{ring(outline), {}}});
  const auto contacts = sheet.contacts(disc({-2, 10}, 4.0, 64));
  BOOST_TEST_REQUIRE(contacts.size() == 2u);
  BOOST_TEST(contacts[0].midpoint.y < contacts[1].midpoint.y);
  for (const ContactRegion& contact : contacts) {
    BOOST_TEST(norm(contact.normal) == 1.0, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(contact.normal.x > 0.0);
  }
}

BOOST_AUTO_TEST_CASE(a_notch_in_the_contact_counts_with_the_longest_free_edge_in_front) {
  // The section's far side sees a slot from behind: its boundary lies in the ice in two pieces.
  const Vec2 outline[] = {{0, 0}, {10, 0}, {10, 20}, {0, 20}};
  const IceSheet sheet = sheet_of({{ring(outline), {box(1, 9, 3, 11)}}});
  const auto contacts = sheet.contacts(box(-1, 6, 2, 14));
  BOOST_TEST_REQUIRE(contacts.size() == 1u);
  BOOST_TEST(area(contacts[0].overlap).square_metres() == 16.0 - 2.0);
  expect_near(contacts[0].chord_from, {0, 6});
  expect_near(contacts[0].chord_to, {0, 14});
  expect_near(contacts[0].midpoint, {0, 10});
}

BOOST_AUTO_TEST_CASE(a_section_surrounded_by_ice_and_ice_inside_the_section_have_no_chord) {
  const IceSheet sheet = sheet_of({{box(0, 0, 50, 50), {}}});
  const auto inside = sheet.contacts(disc({25, 25}, 2.0, 32));
  BOOST_TEST_REQUIRE(inside.size() == 1u);
  BOOST_TEST(inside[0].contact_length == 0.0);
  BOOST_TEST((inside[0].normal == Vec2{}));
  // The centroid of a regular polygon, up to the rounding of its vertices.
  expect_near(inside[0].midpoint, {25, 25});

  const IceSheet floe = sheet_of({{box(-1, -1, 1, 1), {}}});
  const auto around = floe.contacts(box(-10, -10, 10, 10));
  BOOST_TEST_REQUIRE(around.size() == 1u);
  BOOST_TEST(around[0].contact_length == 0.0);
  BOOST_TEST((around[0].overlap.outline == box(-1, -1, 1, 1)));
  // Half way round the outline from its first vertex.
  expect_near(around[0].midpoint, {1, 1});
}

BOOST_AUTO_TEST_CASE(a_section_that_only_touches_the_edge_has_no_contact) {
  const IceSheet sheet = sheet_of({{box(0, 0, 50, 50), {}}});
  BOOST_TEST(sheet.contacts(box(-3, 20, 0, 24)).empty());
  BOOST_TEST(sheet.contacts(box(-3, -3, 0, 0)).empty());
  BOOST_TEST(sheet.contacts(box(-3, 20, -1, 24)).empty());
}

BOOST_AUTO_TEST_CASE(a_section_that_is_not_convex_is_a_broken_contract) {
  const IceSheet sheet = sheet_of({{box(0, 0, 50, 50), {}}});
  const Vec2 dart[] = {{0, 0}, {4, 0}, {1, 1}, {0, 4}};
  BOOST_CHECK_THROW((void)sheet.contacts(ring(dart)), ContractViolation);
}

BOOST_AUTO_TEST_CASE(the_ice_within_a_window_is_what_a_cut_there_would_take) {
  IceSheet sheet = sheet_of({{box(0, 0, 50, 50), {box(10, 10, 12, 12)}}});
  sheet.cut(disc({0, 11}, 5.0, 24));
  const Ring window = disc({4, 8}, 7.5, 20);
  const std::vector<Polygon> seen = sheet.within(window);
  const ExactArea before = sheet.area();
  BOOST_TEST((sheet.cut(window).pieces == seen));
  BOOST_TEST((before != sheet.area()));
}

BOOST_AUTO_TEST_CASE(the_free_edge_near_a_point_ends_on_the_circle_and_starts_with_the_nearest_chain) {
  const IceSheet sheet = sheet_of({{box(0, 0, 50, 50), {box(3, 24, 4, 26)}}});
  const auto chains = sheet.free_edge({0, 25}, 5.0);
  BOOST_TEST_REQUIRE(chains.size() == 2u);
  BOOST_TEST_REQUIRE(chains[0].size() == 2u);
  expect_near(chains[0][0], {0, 30});
  expect_near(chains[0][1], {0, 20});
  BOOST_TEST(chains[1].size() == 5u);
  BOOST_TEST((chains[1].front() == chains[1].back()));
  BOOST_TEST(sheet.free_edge({25, 25}, 5.0).empty());
  const auto corner = sheet.free_edge({0, 0}, 2.0);
  BOOST_TEST_REQUIRE(corner.size() == 1u);
  BOOST_TEST_REQUIRE(corner[0].size() == 3u);
  expect_near(corner[0][0], {0, 2});
  expect_near(corner[0][1], {0, 0});
  expect_near(corner[0][2], {2, 0});
}

BOOST_AUTO_TEST_SUITE_END()
