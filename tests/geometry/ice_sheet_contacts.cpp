// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "brash/core/contract.hpp"
#include "brash/geometry/ice_sheet.hpp"
#include "shapes.hpp"

using namespace brash;
using namespace brash::geometry;

namespace {

// Vertices are rounded to 2^-30 m = 0.93 nm; lengths here are of the order of a metre.
constexpr double kGridTolerance = 4e-9;

using shapes::box;

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

BOOST_AUTO_TEST_CASE(a_forked_section_has_a_contact_at_each_prong) {
  const IceSheet sheet = sheet_of({{box(0, 0, 50, 50), {}}});
  const Vec2 fork[] = {{-3, 20}, {1, 20}, {1, 21}, {-1, 21}, {-1, 23}, {2, 23}, {2, 24}, {-3, 24}};
  const auto contacts = sheet.contacts(ring(fork));
  BOOST_TEST_REQUIRE(contacts.size() == 2u);
  BOOST_TEST(area(contacts[0].overlap).square_metres() == 1.0);
  BOOST_TEST(area(contacts[1].overlap).square_metres() == 2.0);
  expect_near(contacts[0].chord_from, {0, 20});
  expect_near(contacts[0].chord_to, {0, 21});
  expect_near(contacts[0].midpoint, {0, 20.5});
  expect_near(contacts[1].midpoint, {0, 23.5});
  for (const ContactRegion& contact : contacts) {
    expect_near(contact.normal, {1, 0});
    BOOST_TEST(contact.contact_length == 1.0);
  }
}

BOOST_AUTO_TEST_CASE(a_notch_in_the_section_within_the_ice_leaves_one_contact_without_its_area) {
  const IceSheet sheet = sheet_of({{box(0, 0, 50, 50), {}}});
  const Vec2 notched[] = {{-3, 20}, {2, 20}, {2, 21}, {1, 22}, {2, 23}, {2, 24}, {-3, 24}};
  const auto contacts = sheet.contacts(ring(notched));
  BOOST_TEST_REQUIRE(contacts.size() == 1u);
  BOOST_TEST(area(contacts[0].overlap).square_metres() == 8.0 - 1.0);
  expect_near(contacts[0].chord_from, {0, 20});
  expect_near(contacts[0].chord_to, {0, 24});
  expect_near(contacts[0].midpoint, {0, 22});
  expect_near(contacts[0].normal, {1, 0});
}

BOOST_AUTO_TEST_CASE(a_notch_that_ends_on_the_edge_parts_the_contact_in_two) {
  const IceSheet sheet = sheet_of({{box(0, 0, 50, 50), {}}});
  const Vec2 notched[] = {{-3, 20}, {2, 20}, {2, 21}, {0, 22}, {2, 23}, {2, 24}, {-3, 24}};
  const auto contacts = sheet.contacts(ring(notched));
  BOOST_TEST_REQUIRE(contacts.size() == 2u);
  for (const ContactRegion& contact : contacts) {
    BOOST_TEST(area(contact.overlap).square_metres() == 3.0);
    BOOST_TEST(contact.contact_length == 2.0);
    expect_near(contact.normal, {1, 0});
  }
  expect_near(contacts[0].midpoint, {0, 21});
  expect_near(contacts[1].midpoint, {0, 23});
}

BOOST_AUTO_TEST_CASE(a_vertex_of_the_section_on_the_edge_alone_is_no_contact) {
  const IceSheet sheet = sheet_of({{box(0, 0, 50, 50), {}}});
  const Vec2 bow[] = {{-3, 20}, {-1, 21.5}, {0, 22}, {-1, 22.5}, {-3, 24}, {-2, 22}};
  BOOST_TEST(sheet.contacts(ring(bow)).empty());
}

BOOST_AUTO_TEST_CASE(a_bow_with_a_hollow_waterline_pushes_ahead_at_its_stem) {
  const IceSheet sheet = sheet_of({{box(0, 0, 50, 50), {}}});
  // The flanks swing inwards behind the stem and outwards to the shoulders, which touch the edge's line from outside.
  const Vec2 bow[] = {{-9, 18}, {-4, 18}, {-1, 24}, {3, 25}, {-1, 26}, {-4, 32}, {-9, 32}};
  const auto contacts = sheet.contacts(ring(bow));
  BOOST_TEST_REQUIRE(contacts.size() == 1u);
  // On the edge the stem is 2 m 3 / 4 = 1.5 m wide.
  BOOST_TEST(contacts[0].contact_length == 1.5);
  expect_near(contacts[0].midpoint, {0, 25});
  expect_near(contacts[0].normal, {1, 0});
}

BOOST_AUTO_TEST_CASE(random_hollow_sections_overlap_what_a_cut_would_take) {
  std::mt19937_64 generator(5);
  IceSheet sheet = sheet_of({{box(0, 0, 50, 50), {box(1, 24, 2, 26)}}});
  std::size_t n_contacts = 0;
  for (int i = 0; i < 100; ++i) {
    const double y = 5 + 40 * shapes::uniform(generator);
    Ring section = shapes::star(generator, 7 + i % 20, 0.1, {0.5 * shapes::uniform(generator), 0});
    // On the grid, three times as large and beside the edge.
    for (Point& p : section) p = Point::of_units(3 * p.x, 3 * p.y + snap({0, y}).y);
    std::vector<Polygon> overlaps;
    for (const ContactRegion& contact : sheet.contacts(section)) {
      if (contact.contact_length > 0.0) {
        BOOST_TEST(!sheet.free_edge(contact.midpoint, kGridTolerance).empty());
        BOOST_TEST(norm(contact.normal) == 1.0, boost::test_tools::tolerance(1e-12));
      }
      overlaps.push_back(contact.overlap);
    }
    n_contacts += overlaps.size();
    std::vector<Polygon> taken = sheet.within(section);
    std::sort(overlaps.begin(), overlaps.end(),
              [](const Polygon& a, const Polygon& b) { return a.outline < b.outline; });
    BOOST_TEST((overlaps == taken));
    if (i % 2 == 0) BOOST_TEST((sheet.cut(section).pieces == taken));
  }
  // Stars meet the edge with several of their points.
  BOOST_TEST(n_contacts > 150u);
}

BOOST_AUTO_TEST_CASE(a_section_that_crosses_itself_or_runs_clockwise_is_a_broken_contract) {
  const IceSheet sheet = sheet_of({{box(0, 0, 50, 50), {}}});
  const Vec2 crossed[] = {{0, 0}, {4, 4}, {4, 0}, {1, 4}};
  Ring bow_tie;
  for (const Vec2 v : crossed) bow_tie.push_back(snap(v));
  if (signed_area(bow_tie) < ExactArea{}) std::reverse(bow_tie.begin(), bow_tie.end());
  BOOST_CHECK_THROW((void)sheet.contacts(bow_tie), ContractViolation);
  BOOST_CHECK_THROW((void)sheet.contacts(shapes::reversed(box(-1, 1, 1, 2))), ContractViolation);
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
