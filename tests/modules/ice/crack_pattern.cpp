// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/ice/crack_pattern.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <set>

#include "level_ice.hpp"

namespace {

using namespace brash;
using namespace brash::ice;
using namespace brash::ice::testing;

/// A contact with the front edge, which is crushed to the depth `crushed` over 1 m.
geometry::ContactRegion at_the_edge(double crushed = 0.0) {
  geometry::ContactRegion contact;
  contact.midpoint = {0.0, 1.0};
  contact.chord_from = {crushed, 1.5};
  contact.chord_to = {crushed, 0.5};
  contact.normal = {1.0, 0.0};
  return contact;
}

BOOST_AUTO_TEST_SUITE(crack_patterns)

BOOST_AUTO_TEST_CASE(a_circumferential_crack_has_the_breaking_length_as_radius_and_its_wedges_at_random) {
  const Field field = level_ice(50.0, 50.0);
  const auto pattern = make_crack_pattern({});
  std::set<int> drawn;
  for (std::uint64_t n = 0; n < 50; ++n) {
    statistics::RandomStream random(1, "cone", 0, "wedges", n);
    const CrackPlan plan = pattern->plan(field.level_ice()[0], at_the_edge(), {.breaking_length = 2.0}, random);
    drawn.insert(plan.n_wedges);
    BOOST_TEST(plan.cracked.cracks.size() == static_cast<std::size_t>(plan.n_wedges - 1));  // one edge is free
    BOOST_TEST((plan.centre == at_the_edge().midpoint));
    BOOST_TEST(plan.reach == 2.0);
    for (const geometry::Point corner : plan.cracked.region)
      BOOST_TEST(std::abs(norm(geometry::metres(corner) - plan.centre) - 2.0) < 2.0 * geometry::kGridUnit);
  }
  BOOST_TEST((drawn == std::set<int>{3, 4, 5}));
}

BOOST_AUTO_TEST_CASE(the_circle_is_centred_where_the_breaking_length_starts) {
  const Field field = level_ice(50.0, 50.0);
  const auto pattern = make_crack_pattern({});
  statistics::RandomStream random(1, "cone", 0, "wedges", 0);
  const CrackPlan plan = pattern->plan(field.level_ice()[0], at_the_edge(0.25), {.breaking_length = 2.0}, random);
  BOOST_TEST((plan.centre == Vec2{0.25, 1.0}));
  double farthest = 0.0;
  for (const geometry::Point corner : plan.cracked.region) farthest = std::max(farthest, geometry::metres(corner).x);
  BOOST_TEST(farthest == 2.25, boost::test_tools::tolerance(1e-8));
}

BOOST_AUTO_TEST_CASE(a_disc_in_place_of_a_crack_that_cuts_nothing_off_is_no_smaller_than_the_ice_is_thick) {
  const Field field = level_ice(50.0, 50.0);
  model::FailureSection section;
  section.pattern = model::CrackPattern::kStress;
  const auto pattern = make_crack_pattern(section);
  statistics::RandomStream random(1, "cone", 0, "wedges", 0);
  const failure::Assessment beside{
      .fails = true, .breaking_length = 0.1, .crack = {{-0.1, 3.0}, {0.5, 3.0}, {0.5, 4.0}, {-0.1, 4.0}}};
  const CrackPlan plan = pattern->plan(field.level_ice()[0], at_the_edge(), beside, random);
  BOOST_TEST(!plan.along_stress);
  BOOST_TEST(plan.reach == properties().thickness);
}

BOOST_AUTO_TEST_CASE(cracks_that_meet_inside_the_ice_go_on_to_its_edge) {
  const auto pattern = make_crack_pattern({});
  for (std::uint64_t n = 0; n < 20; ++n) {
    Field field = level_ice(50.0, 50.0);
    ice::Plate& plate = field.level_ice(0);
    statistics::RandomStream random(1, "cone", 0, "wedges", n);
    const CrackPlan plan = pattern->plan(plate, at_the_edge(0.25), {.breaking_length = 2.0}, random);
    BOOST_TEST(field.break_off(plate, plan, {}, 0.01).pieces.size() == static_cast<std::size_t>(plan.n_wedges));
  }
}

BOOST_AUTO_TEST_CASE(one_stream_gives_one_plan) {
  const Field field = level_ice(50.0, 50.0);
  const auto pattern = make_crack_pattern({});
  const auto region = [&] {
    statistics::RandomStream random(7, "cone", 0, "wedges", 3);
    return pattern->plan(field.level_ice()[0], at_the_edge(), {.breaking_length = 2.0}, random).cracked.region;
  };
  BOOST_TEST((region() == region()));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
