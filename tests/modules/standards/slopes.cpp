// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "brash/core/contract.hpp"
#include "brash/standards/croasdale.hpp"
#include "brash/standards/ralston.hpp"

namespace {

using namespace brash;
using namespace brash::standards;
using boost::test_tools::tolerance;

/// The log of a published implementation (IceFloe of OpenFAST), whose g is 9.81.
CroasdaleInput published_case() {
  CroasdaleInput in;
  in.thickness = 1.0;
  in.width = 5.0;
  in.flexural_strength = 7e5;
  in.slope = radians(60.0);
  in.friction_structure = 0.15;
  in.friction_ice = 0.05;
  in.ice_density = 916.2;
  in.water_density = 999.8;
  in.rubble_height = 3.0;
  in.rubble_porosity = 0.3;
  in.rubble_cohesion = 0.0;
  in.rubble_angle = radians(40.0);
  in.rubble_friction_angle = radians(45.0);
  in.youngs_modulus = 8e9;
  in.poisson_ratio = 0.3;
  in.gravity = 9.81;
  return in;
}

/// The cone of the paper's Table 1, no rubble.
CroasdaleInput paper_cone() {
  CroasdaleInput in;
  in.slope = radians(61.4);
  in.width = 13.6;
  in.thickness = 0.33;
  in.flexural_strength = 539e3;
  in.youngs_modulus = 0.35e9;
  in.friction_structure = 0.027;
  in.friction_ice = 0.3;
  return in;
}

RalstonInput paper_cone_downward() {
  RalstonInput in;
  in.slope = radians(61.4);
  in.waterline_width = 13.6;
  in.end_width = 13.6 - 2.0 * 5.68 / std::tan(radians(61.4));  // keel, 5.68 m below the water
  in.thickness = 0.33;
  in.flexural_strength = 539e3;
  in.friction_structure = 0.027;
  in.breaking = Breaking::kDownward;
  return in;
}

/// Half a unit in the last digit that the log prints.
void check_printed(double value, double printed, double last_digit) {
  BOOST_CHECK_SMALL(value - printed, 0.5 * last_digit + 1e-9);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(croasdale_method)

BOOST_AUTO_TEST_CASE(the_components_of_a_published_calculation_are_reproduced_to_its_digits) {
  const auto load = croasdale(published_case()).value();
  check_printed(load.pushing, 2242.0, 1.0);
  check_printed(load.lifting, 2.09678e5, 1.0);
  check_printed(load.turning, 42609.0, 1.0);
  check_printed(load.ride_up, 4.08262e5, 1.0);
  check_printed(load.breaking, 1.84414e6, 10.0);
  check_printed(load.horizontal, 2.65997e6, 10.0);
}

BOOST_AUTO_TEST_CASE(the_papers_cone_without_rubble_takes_319_kilonewtons) {
  // Weight rho_i, no rubble: bending 285 kN, turning of blocks 11 kN, and 8 % for the in-plane compression.
  const auto load = croasdale(paper_cone()).value();
  BOOST_TEST(load.characteristic_length == 3.272, tolerance(2e-4));
  BOOST_CHECK_SMALL(load.horizontal - 319e3, 0.5e3);
  BOOST_CHECK_SMALL(load.breaking - 285e3, 0.5e3);
  BOOST_TEST(load.pushing == 0.0);
  BOOST_TEST(load.ride_up == 0.0);
  BOOST_TEST(load.lifting == 0.0);
  BOOST_TEST(load.vertical * load.force_ratio == load.horizontal, tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(the_parts_sum_to_the_whole_with_the_in_plane_factor) {
  const auto load = croasdale(published_case()).value();
  const double sum = load.breaking + load.pushing + load.ride_up + load.lifting + load.turning;
  BOOST_TEST(load.horizontal == sum * load.in_plane_factor, tolerance(1e-14));
  BOOST_TEST(load.in_plane_factor > 1.0);
}

BOOST_AUTO_TEST_CASE(the_force_ratio_is_that_of_coulomb_friction_on_the_slope) {
  const auto load = croasdale(published_case()).value();
  // A force inclined by slope plus friction angle from the vertical.
  BOOST_TEST(load.force_ratio == std::tan(radians(60.0) + std::atan(0.15)), tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(submerged_weight_lowers_what_downward_breaking_must_push_under) {
  CroasdaleInput in = published_case();
  const auto up = croasdale(in).value();
  in.weight_density = in.water_density - in.ice_density;
  const auto down = croasdale(in).value();
  const double ratio = in.weight_density / in.ice_density;
  BOOST_TEST(down.breaking == up.breaking, tolerance(1e-14));
  BOOST_TEST(down.pushing == ratio * up.pushing, tolerance(1e-13));
  BOOST_TEST(down.ride_up == ratio * up.ride_up, tolerance(1e-13));
  BOOST_TEST(down.lifting == ratio * up.lifting, tolerance(1e-13));  // no cohesion
  BOOST_TEST(down.turning == ratio * up.turning, tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(inputs_outside_the_method_are_refused_with_a_reason) {
  CroasdaleInput locked = paper_cone();
  locked.friction_structure = 0.6;  // tan 61.4 deg = 1.83 > 1 / 0.6
  BOOST_TEST(!croasdale(locked).has_value());
  CroasdaleInput flat = paper_cone();
  flat.slope = radians(1.0);
  BOOST_TEST(!croasdale(flat).has_value());
  CroasdaleInput steep_rubble = paper_cone();
  steep_rubble.rubble_height = 1.0;
  steep_rubble.rubble_angle = radians(62.0);
  BOOST_TEST(!croasdale(steep_rubble).has_value());
  CroasdaleInput broken;
  BOOST_CHECK_THROW((void)croasdale(broken), ContractViolation);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(ralston_method)

BOOST_AUTO_TEST_CASE(the_papers_cone_downward_takes_275_kilonewtons) {
  // Tresca, submerged weight in breaking and riding, one layer of ice down to the keel, whose width is 7.41 m.
  const RalstonInput in = paper_cone_downward();
  BOOST_TEST(in.end_width == 7.41, tolerance(1e-3));
  const auto load = ralston(in).value();
  BOOST_CHECK_SMALL(load.horizontal - 275e3, 0.5e3);
  BOOST_CHECK_SMALL(load.breaking_horizontal - 221e3, 0.5e3);
  BOOST_CHECK_SMALL(load.ride_horizontal - 54e3, 0.5e3);
  BOOST_CHECK_SMALL(load.vertical - 180e3, 0.5e3);
}

BOOST_AUTO_TEST_CASE(upward_breaking_lifts_the_whole_weight_and_takes_more) {
  RalstonInput in = paper_cone_downward();
  in.breaking = Breaking::kUpward;
  const auto up = ralston(in).value();
  const auto down = ralston(paper_cone_downward()).value();
  BOOST_TEST(up.ride_horizontal == down.ride_horizontal * 900.0 / 125.0, tolerance(1e-13));
  BOOST_TEST(up.breaking_horizontal > down.breaking_horizontal);
}

BOOST_AUTO_TEST_CASE(both_yield_criteria_minimise_their_upper_bound_to_1_2_per_cent) {
  // The closed form of the crack radius is the root of the minimum's equation for a crack close to the cone.
  for (const Yield yield : {Yield::kTresca, Yield::kJohansen}) {
    const double Y = yield == Yield::kTresca ? 2.711 : 3.422;
    for (const double thickness : {0.05, 0.33, 1.0, 3.0, 30.0}) {
      RalstonInput in = paper_cone_downward();
      in.yield = yield;
      in.thickness = thickness;
      const double G = 125.0 * kGravity * 13.6 * 13.6 / (4.0 * in.flexural_strength * thickness);
      const auto bound = [&](double x) { return (1.0 + Y * x * std::log(x)) / (x - 1.0) + G * (x - 1.0) * (x + 2.0); };
      double least = bound(1.01);
      for (double x = 1.01; x < 4.0; x += 1e-4) least = std::min(least, bound(x));
      const double used = bound(ralston(in).value().radius_ratio);
      BOOST_TEST(used >= least * (1.0 - 1e-9));  // the scan's grid
      BOOST_TEST(used <= least * 1.012);
    }
  }
}

BOOST_AUTO_TEST_CASE(without_friction_the_vertical_force_is_that_of_normal_pressure_with_a_cosine_around_the_front) {
  RalstonInput in = paper_cone_downward();
  in.friction_structure = 0.0;
  const auto load = ralston(in).value();
  BOOST_TEST(load.breaking_vertical / load.breaking_horizontal == 4.0 / kPi / std::tan(in.slope), tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(friction_that_locks_the_ice_is_refused_with_a_reason) {
  RalstonInput in = paper_cone_downward();
  in.friction_structure = 0.6;
  BOOST_TEST(!ralston(in).has_value());
  in.slope = radians(90.0);
  BOOST_CHECK_THROW((void)ralston(in), ContractViolation);
}

BOOST_AUTO_TEST_SUITE_END()
