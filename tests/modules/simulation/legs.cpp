// SPDX-License-Identifier: GPL-3.0-or-later
// Structures of several legs in the step.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "brash/core/constants.hpp"
#include "brash/io/case.hpp"
#include "brash/simulation/run.hpp"

namespace {

using namespace brash;

/// Cones of 6 m with Nevel's wedges in ice 90 m wide, for some seconds.
model::Case case_of(const std::string& keys, double duration, const std::string& preset = "paper") {
  return io::parse_case(
      "[algorithm]\npreset = \"" + preset +
          "\"\n[ice]\nthickness = 0.33\nyoungs_modulus = 0.35e9\nflexural_strength = 539e3\n"
          "[structure]\nangle = \"61.4 deg\"\nwaterline_width = 6\nheight = 6\nheight_under_water = 4\n" +
          keys +
          "[field]\nlength = 50\nwidth = 90\ninitial_crack = false\n[failure]\nmodel = \"wedge\"\n"
          "[time]\nduration = " +
          std::to_string(duration) + "\n",
      "legs.toml", {});
}

const std::string kTow = "speed = 1.2\nstart_distance = 4\n";

BOOST_AUTO_TEST_SUITE(legs)

BOOST_AUTO_TEST_CASE(one_leg_at_the_origin_runs_as_the_shape_alone) {
  const simulation::Run alone = simulation::run(case_of(kTow, 8.0));
  const simulation::Run leg = simulation::run(case_of(kTow + "legs = [[0, 0]]\n", 8.0));
  BOOST_REQUIRE(alone.results.events.size() > 2u);
  BOOST_REQUIRE(leg.results.loads.size() == alone.results.loads.size());
  for (std::size_t i = 0; i < alone.results.loads.size(); ++i) {
    model::LoadRow row = leg.results.loads[i];
    const Vec3 on_leg = row.regions[model::kHullRegions].total, total = row.total.force;
    BOOST_TEST(norm(on_leg - total) <= 1e-9 * (1.0 + norm(total)));
    row.regions = {};
    BOOST_TEST((row == alone.results.loads[i]));
  }
}

BOOST_AUTO_TEST_CASE(legs_far_apart_bear_each_what_one_bears_alone_until_the_ice_breaks) {
  const simulation::Run alone = simulation::run(case_of(kTow, 2.0));
  const simulation::Run two = simulation::run(case_of(kTow + "legs = [[0, 24], [0, -24]]\n", 2.0));
  BOOST_REQUIRE(!alone.results.events.empty());
  const double first_break = std::min(alone.results.events.front().time, two.results.events.front().time);
  double largest = 0.0;
  for (std::size_t i = 0; i < alone.results.loads.size(); ++i) {
    if (alone.results.loads[i].time >= first_break) break;
    const Vec3 expected = alone.results.loads[i].total.force;
    // Rounding to the grid moves outlines by 2^-30 m, some 0.01 N.
    for (const std::size_t leg : {0, 1}) {
      const Vec3 force = two.results.loads[i].regions[model::kHullRegions + leg].total;
      BOOST_TEST(norm(force - expected) <= 0.1);
    }
    BOOST_TEST(norm(two.results.loads[i].total.force - 2.0 * expected) <= 0.2);
    BOOST_TEST(std::abs(two.results.loads[i].work - 2.0 * alone.results.loads[i].work) <= 1.0);
    largest = std::max(largest, expected.x);
  }
  BOOST_TEST(largest > 1e3);
}

BOOST_AUTO_TEST_CASE(legs_that_meet_no_ice_have_means_of_zero) {
  const simulation::Run run =
      simulation::run(case_of(kTow + "legs = [[0, 24], [0, -24]]\n[output]\nstatistics_from = 0\n", 0.1));
  BOOST_REQUIRE(run.summary.regions.size() == 2u);
  BOOST_TEST((run.summary.regions[1].load == model::RegionLoad{}));
}

BOOST_AUTO_TEST_CASE(a_ship_that_meets_no_ice_has_means_of_zero) {
  // A campaign leaves missing numbers out, so its mean over replicates would be too high without them.
  const simulation::Run run =
      simulation::run(io::read_case(BRASH_SOURCE_DIR "/experiments/ships/icebreaker.toml",
                                    {"time.duration=0.1", "output.statistics_from=0", "structure.start_distance=50"}));
  BOOST_TEST(run.summary.horizontal.mean == 0.0);
  BOOST_REQUIRE(run.summary.regions.size() == model::kHullRegions);
  for (const auto& region : run.summary.regions) BOOST_TEST((region.load == model::RegionLoad{}));
}

BOOST_AUTO_TEST_CASE(the_leg_behind_goes_through_the_channel_of_the_one_ahead) {
  const simulation::Run run =
      simulation::run(case_of("speed = 1.2\nstart_distance = 12\nlegs = [[8, 0], [-8, 0]]\n", 21.0));
  const auto& regions = run.summary.regions;
  BOOST_REQUIRE(regions.size() == 2u);
  BOOST_TEST(regions[0].region == "leg_1");
  BOOST_TEST(regions[1].region == "leg_2");
  // The second one meets no edge ahead.
  BOOST_TEST(regions[0].load.crushing.x > 100.0);
  BOOST_TEST(regions[1].load.crushing.x < 0.2 * regions[0].load.crushing.x);
  Vec3 sum{};
  for (const auto& region : regions) sum += region.load.total;
  BOOST_TEST(sum.x == run.summary.horizontal.mean, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(the_first_crack_is_ahead_of_each_leg_with_a_way_of_its_own) {
  model::Case resolved = case_of("speed = 1.2\nstart_distance = 12\nlegs = [[8, 20], [-8, 20], [0, -20]]\n", 0.1);
  resolved.field.initial_crack = true;
  resolved.field.initial_crack_radius = 3.0;
  const simulation::Simulation simulation(resolved);
  int port = 0, starboard = 0;
  for (const model::FloeRecord& birth : simulation.initial_births())
    (birth.birth_pose.position.y > 0.0 ? port : starboard) += 1;
  BOOST_TEST(port > 0);
  BOOST_TEST(starboard > 0);
  BOOST_TEST(std::abs(port - starboard) <= std::max(port, starboard) / 2);
}

/// The floes of a first crack with a radius of 3 m.
std::vector<model::FloeRecord> first_floes(const std::string& keys) {
  model::Case resolved = case_of(keys, 0.1);
  resolved.field.initial_crack = true;
  resolved.field.initial_crack_radius = 3.0;
  return simulation::Simulation(resolved).initial_births();
}

/// Pieces of half a disc around (0, y): their centres lie in it.
void check_around(const std::vector<model::FloeRecord>& floes, double y) {
  BOOST_TEST(!floes.empty());
  for (const model::FloeRecord& floe : floes) {
    const Vec3 place = floe.birth_pose.position;
    BOOST_TEST(place.x > 0.0);
    BOOST_TEST(std::hypot(place.x, place.y - y) < 3.0);
  }
}

BOOST_AUTO_TEST_CASE(the_first_crack_lies_where_the_course_at_the_start_meets_the_edge) {
  check_around(first_floes("motion.path = [[0, -20, 30, 0], [20, 4, 30, 0]]\n"), 30.0);
  check_around(first_floes("motion.path = [[0, -12, -10, 0.5], [20, 12, 14, 0.5]]\n"), 2.0);
  // Turned by a quarter, the legs stand one behind the other on the way.
  check_around(first_floes("motion.path = [[0, -30, 8, 1.5707963267948966], [20, -6, 8, 1.5707963267948966]]\n"
                           "legs = [[0, 20], [0, -20]]\n"),
               8.0);
}

BOOST_AUTO_TEST_CASE(no_first_crack_opens_where_the_course_misses_the_sheet) {
  // Past the corner, away from the edge, and in from the side.
  for (const char* const path :
       {"[[0, -10, 30, 0], [20, 0, 50, 0]]", "[[0, -10, 0, 0], [20, -30, 0, 3]]", "[[0, 10, 60, 0], [20, 14, 30, 0]]"})
    BOOST_TEST(first_floes(std::string("motion.path = ") + path + "\n").empty(), path);
}

BOOST_AUTO_TEST_CASE(statistics_begin_when_the_last_leg_is_in_the_ice) {
  const std::string legs = "legs = [[0, 6], [0, -6], [-9, 6], [-9, -6]]\n";
  BOOST_TEST(simulation::statistics_window(case_of(kTow + legs, 20.0, "brash"), 0.0).from == 13.0 / 1.2,
             boost::test_tools::tolerance(1e-12));
  BOOST_TEST(simulation::statistics_window(case_of(kTow, 20.0, "brash"), 0.0).from == 4.0 / 1.2);
  // Turned by a quarter, two of the legs are 6 m behind.
  const model::Case turned =
      case_of("motion.path = [[0, -12, 0, 1.5708], [20, 12, 0, 1.5708]]\n" + legs, 20.0, "brash");
  BOOST_TEST(simulation::statistics_window(turned, 0.0).from == 18.0 / 1.2, boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
