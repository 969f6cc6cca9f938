// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/standards/lindqvist.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "brash/core/contract.hpp"

namespace {

using namespace brash;
using namespace brash::standards;
using boost::test_tools::tolerance;

LindqvistInput icebreaker() {
  LindqvistInput in;
  in.length = 75.2;
  in.breadth = 18.0;
  in.draught = 6.5;
  in.stem_angle = radians(30.0);
  in.waterline_angle = radians(35.0);
  in.speed = 2.0;
  in.thickness = 1.0;
  in.flexural_strength = 5e5;
  in.youngs_modulus = 5e9;
  in.friction = 0.1;
  return in;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(lindqvist_method)

BOOST_AUTO_TEST_CASE(an_icebreaker_has_the_parts_of_a_second_transcription) {
  // Numbers from a separate transcription of the four formulas in Python, 12 digits.
  const LindqvistLoad load = lindqvist(icebreaker()).value();
  BOOST_TEST(load.crushing == 188424.617048, tolerance(1e-11));
  BOOST_TEST(load.bending == 52533.5116076, tolerance(1e-11));
  BOOST_TEST(load.submersion == 211991.270747, tolerance(1e-11));
  BOOST_TEST(load.total == 815155.43295, tolerance(1e-11));
}

BOOST_AUTO_TEST_CASE(at_rest_the_parts_sum_to_the_whole) {
  LindqvistInput in = icebreaker();
  in.speed = 0.0;
  const LindqvistLoad load = lindqvist(in).value();
  BOOST_TEST(load.total == load.crushing + load.bending + load.submersion, tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(without_friction_a_blunt_bow_submerges_ice_by_its_potential_energy_alone) {
  LindqvistInput in = icebreaker();
  in.friction = 0.0;
  const LindqvistLoad load = lindqvist(in).value();
  const double volume_height = 6.5 * (18.0 + 6.5) / (18.0 + 13.0);
  BOOST_TEST(load.submersion == 125.0 * kGravity * 18.0 * volume_height, tolerance(1e-14));
  BOOST_TEST(load.crushing == 0.5 * 5e5 * std::tan(radians(30.0)), tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(resistance_grows_with_thickness_speed_and_friction) {
  const double reference = lindqvist(icebreaker())->total;
  LindqvistInput thicker = icebreaker(), faster = icebreaker(), rougher = icebreaker();
  thicker.thickness = 1.1;
  faster.speed = 3.0;
  rougher.friction = 0.15;
  BOOST_TEST(lindqvist(thicker)->total > reference);
  BOOST_TEST(lindqvist(faster)->total > reference);
  BOOST_TEST(lindqvist(rougher)->total > reference);
}

BOOST_AUTO_TEST_CASE(a_bow_that_locks_is_refused_with_a_reason) {
  LindqvistInput in = icebreaker();
  in.stem_angle = radians(80.0);
  in.friction = 0.3;
  BOOST_TEST(!lindqvist(in).has_value());
  in.draught = 0.0;
  BOOST_CHECK_THROW((void)lindqvist(in), ContractViolation);
}

BOOST_AUTO_TEST_SUITE_END()
