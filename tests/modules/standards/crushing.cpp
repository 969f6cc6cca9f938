// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/standards/crushing.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

namespace {

using namespace brash::standards;
namespace tt = boost::test_tools;

BOOST_AUTO_TEST_CASE(ice_of_one_metre_on_a_hundred_metres_has_the_pressure_of_its_width_alone) {
  const auto load = global_crushing({.width = 100.0, .thickness = 1.0});
  BOOST_REQUIRE(load.has_value());
  BOOST_TEST(load->pressure == 2.8e6 * std::exp(-0.16 * std::log(100.0)), tt::tolerance(1e-12));
  BOOST_TEST(load->pressure == 1.340e6, tt::tolerance(1e-3));
  BOOST_TEST(load->horizontal == load->pressure * 100.0, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(thin_ice_presses_harder_and_the_exponent_is_continuous_at_one_metre) {
  const auto pressure = [](double h) { return global_crushing({.width = 20.0 * h, .thickness = h})->pressure; };
  BOOST_TEST(pressure(0.5) == pressure(1.0) * std::pow(0.5, -0.4), tt::tolerance(1e-12));
  BOOST_TEST(pressure(2.0) == pressure(1.0) * std::pow(2.0, -0.3), tt::tolerance(1e-12));
  BOOST_TEST(pressure(0.999999) == pressure(1.0), tt::tolerance(1e-5));
}

BOOST_AUTO_TEST_CASE(the_load_of_a_published_calculation_is_reproduced_to_its_digits) {
  // Test logs of IceFloe, part of OpenFAST: a tower of 5 m in ice of 1 m.
  const auto load = global_crushing({.width = 5.0, .thickness = 1.0, .strength_coefficient = 2.2e6});
  BOOST_CHECK_SMALL(load->horizontal - 8.50271e6, 5.0);  // half a unit of the last digit
}

BOOST_AUTO_TEST_CASE(a_face_narrower_than_two_thicknesses_is_refused) {
  BOOST_TEST(!global_crushing({.width = 1.9, .thickness = 1.0}).has_value());
  BOOST_TEST(global_crushing({.width = 2.0, .thickness = 1.0}).has_value());
}

}  // namespace
