// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut_off.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "brash/ice/crack_pattern.hpp"
#include "level_ice.hpp"

namespace {

using namespace brash;
using namespace brash::ice;
using namespace brash::ice::testing;

/// A half circle of radius 2 m around (0, y) into the ice, from past the edge to past the edge.
std::vector<Vec2> half_circle(double y = 0.0, double beyond = 0.05) {
  std::vector<Vec2> crack;
  for (int i = -20; i <= 20; ++i) {
    const double angle = (0.5 * std::numbers::pi + beyond) * i / 20.0;
    crack.push_back({2.0 * std::cos(angle), y + 2.0 * std::sin(angle)});
  }
  return crack;
}

/// Of the ice between the half circle's chords and the edge [m2]: the polygon of its points at x >= 0.
double area_behind(const std::vector<Vec2>& crack) {
  double twice = 0.0;
  for (std::size_t i = 0; i < crack.size(); ++i) twice += cross(crack[i], crack[(i + 1) % crack.size()]);
  return std::abs(0.5 * twice);
}

geometry::ContactRegion contact_at(double y) {
  geometry::ContactRegion contact;
  contact.midpoint = {0.0, y};
  contact.chord_from = {0.0, y + 0.5};
  contact.chord_to = {0.0, y - 0.5};
  contact.normal = {1.0, 0.0};
  return contact;
}

BOOST_AUTO_TEST_SUITE(cut_off_ice)

BOOST_AUTO_TEST_CASE(the_crack_ends_on_the_free_edge_and_the_region_outside_it) {
  const Field field = level_ice(50.0, 50.0);
  const auto cut = cut_off(field.level_ice()[0].sheet(), {0.0, 0.0}, half_circle());
  BOOST_REQUIRE(cut.has_value());
  for (const Vec2 end : {cut->crack.front(), cut->crack.back()}) BOOST_TEST(std::abs(end.x) < 1e-12);
  BOOST_TEST(cut->crack.front().y * cut->crack.back().y < 0.0);
  for (const Vec2 end : {cut->region.front(), cut->region.back()}) BOOST_TEST(end.x < 0.0);
}

BOOST_AUTO_TEST_CASE(a_crack_just_short_of_the_edge_goes_on_to_it) {
  const Field field = level_ice(50.0, 50.0);
  const auto cut = cut_off(field.level_ice()[0].sheet(), {0.0, 0.0}, half_circle(0.0, -0.05));
  BOOST_REQUIRE(cut.has_value());
  for (const Vec2 end : {cut->crack.front(), cut->crack.back()}) BOOST_TEST(std::abs(end.x) < 1e-12);
}

BOOST_AUTO_TEST_CASE(the_pieces_are_the_ice_between_crack_and_edge) {
  Field field = level_ice(50.0, 50.0);
  Plate& plate = field.level_ice(0);
  model::FailureSection section;
  section.pattern = model::CrackPattern::kStress;
  failure::Assessment assessment{.breaking_length = 2.0};
  assessment.crack = half_circle(3.0);
  const auto cut = cut_off(plate.sheet(), {0.0, 3.0}, assessment.crack);
  BOOST_REQUIRE(cut.has_value());

  statistics::RandomStream random(1, "cone", 0, "wedges", 0);
  const CrackPlan plan = make_crack_pattern(section)->plan(plate, contact_at(3.0), assessment, random);
  const geometry::ExactArea before = plate.area();
  const Broken broken = field.break_off(plate, plan, kFarAway, 0.01);
  BOOST_TEST(broken.pieces.size() == static_cast<std::size_t>(plan.n_wedges));
  BOOST_TEST((before == plate.area() + total(broken.pieces) + field.ledger().snap));
  BOOST_TEST(field.ledger().closes());
  // The grid rounds crossings by 2^-31 m.
  BOOST_TEST(std::abs(total(broken.pieces).square_metres() - area_behind(cut->crack)) < 1e-6);
}

BOOST_AUTO_TEST_CASE(ice_behind_an_earlier_break_is_cut_off_up_to_the_new_edge) {
  Field field = level_ice(50.0, 50.0);
  Plate& plate = field.level_ice(0);
  const geometry::ExactArea whole = plate.area();
  (void)field.break_off(plate, circle(plate, {0.0, 0.0}, 1.0, 3), kFarAway, 0.01);
  const double gap = (whole - plate.area()).square_metres();
  const auto cut = cut_off(plate.sheet(), {1.0, 0.0}, half_circle());
  BOOST_REQUIRE(cut.has_value());
  const geometry::Cut taken = plate.sheet().cut(geometry::ring(cut->region));
  BOOST_REQUIRE(taken.pieces.size() == 1u);
  BOOST_TEST(std::abs(geometry::area(taken.pieces[0]).square_metres() - (area_behind(cut->crack) - gap)) < 1e-6);
}

BOOST_AUTO_TEST_CASE(nothing_is_cut_off_where_the_crack_misses_the_edge) {
  const Field field = level_ice(50.0, 50.0);
  const geometry::IceSheet& sheet = field.level_ice()[0].sheet();
  std::vector<Vec2> inside;
  for (const Vec2 point : half_circle()) inside.push_back(point + Vec2{5.0, 0.0});
  BOOST_TEST(!cut_off(sheet, {0.0, 0.0}, inside).has_value());
  const std::vector<Vec2> whole = half_circle();
  const std::vector<Vec2> one_arm(whole.begin() + 15, whole.end());
  BOOST_TEST(!cut_off(sheet, {0.0, 0.0}, one_arm).has_value());
}

BOOST_AUTO_TEST_CASE(nothing_is_cut_off_where_the_crack_does_not_pass_around_the_tip) {
  const Field field = level_ice(50.0, 50.0);
  const geometry::IceSheet& sheet = field.level_ice()[0].sheet();
  BOOST_TEST(!cut_off(sheet, {0.0, 0.0}, half_circle(10.0)).has_value());
  BOOST_TEST(!cut_off(sheet, {0.0, 0.0}, {}).has_value());
}

BOOST_AUTO_TEST_CASE(nothing_is_cut_off_where_the_region_would_cross_the_edge_beyond_a_notch) {
  // The edge x = 0 turns at the origin to the ledge y = 0. An arm leaves the ice below the corner, towards the ledge.
  const std::vector<Vec2> outline{{-10, 0}, {0, 0}, {0, -10}, {20, -10}, {20, 20}, {-10, 20}};
  const geometry::Polygon ice{geometry::ring(outline), {}};
  geometry::IceSheet sheet = geometry::IceSheet::from_polygons(std::span(&ice, 1)).value();
  const auto crack = [](double below) {
    return std::vector<Vec2>{{-2, -0.05}, {-2, 1}, {0, 2}, {1.5, 0}, {1, -1 - below}, {-0.05, 0.05 - below}};
  };
  BOOST_TEST(!cut_off(sheet, {-1.0, 0.0}, crack(0.0005)).has_value());
  const auto cut = cut_off(sheet, {-1.0, 0.0}, crack(0.01));
  BOOST_REQUIRE(cut.has_value());
  BOOST_TEST(sheet.cut(geometry::ring(cut->region)).pieces.size() == 1u);
}

BOOST_AUTO_TEST_CASE(a_pattern_along_the_stress_cuts_the_disc_where_no_crack_reaches_the_edge) {
  const Field field = level_ice(50.0, 50.0);
  model::FailureSection section;
  section.pattern = model::CrackPattern::kStress;
  statistics::RandomStream random(1, "cone", 0, "wedges", 0);
  const CrackPlan plan =
      make_crack_pattern(section)->plan(field.level_ice()[0], contact_at(0.0), {.breaking_length = 2.0}, random);
  BOOST_TEST(plan.reach == 2.0);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
