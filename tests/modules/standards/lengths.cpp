// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/standards/lengths.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>

#include "brash/core/contract.hpp"
#include "brash/standards/croasdale.hpp"

namespace {

using namespace brash;
using namespace brash::standards;
using boost::test_tools::tolerance;

/// The ice of the paper's Table 1.
PlateInput plate() {
  return {.thickness = 0.33, .youngs_modulus = 0.35e9, .poisson_ratio = 0.3, .water_density = 1025.0};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(lengths_of_a_plate)

BOOST_AUTO_TEST_CASE(the_papers_ice_has_its_known_characteristic_length) {
  BOOST_TEST(characteristic_length(plate()) == 3.272, tolerance(2e-4));
}

BOOST_AUTO_TEST_CASE(the_characteristic_length_balances_bending_and_water) {
  // D/l^4 = rho_w g: the plate's stiffness by its moment of inertia per width, h^3/12.
  const PlateInput in = plate();
  const double inertia = std::pow(in.thickness, 3) / 12.0;
  const double D = in.youngs_modulus / (1.0 - in.poisson_ratio * in.poisson_ratio) * inertia;
  BOOST_TEST(D / std::pow(characteristic_length(in), 4) == in.water_density * kGravity, tolerance(1e-13));
}

BOOST_AUTO_TEST_CASE(the_breaking_length_is_where_the_moment_of_a_half_infinite_strip_is_largest) {
  // l^4 w'''' + w = 0 has the decaying solutions exp(r x/l) with r^4 = -1. No moment at the free end x = 0 leaves
  // w'' = Im exp(r x/l) with r = (-1 + i)/sqrt(2). The largest moment is found by a scan.
  const double l = characteristic_length(plate()), step = 1e-5 * l;
  const std::complex<double> r = std::complex<double>(-1.0, 1.0) / std::sqrt(2.0);
  const auto moment = [&](double x) { return std::exp(r * x / l).imag(); };
  double at = 0.0;
  for (double x = 0.0; x < 5.0 * l; x += step)
    if (moment(x) > moment(at)) at = x;
  BOOST_CHECK_SMALL(breaking_length(plate()) - at, step);
}

BOOST_AUTO_TEST_CASE(croasdale_s_crack_has_the_same_characteristic_length) {
  CroasdaleInput in;
  in.slope = radians(61.4);
  in.width = 13.6;
  in.thickness = 0.33;
  in.flexural_strength = 539e3;
  in.youngs_modulus = 0.35e9;
  in.friction_structure = 0.027;
  BOOST_TEST(croasdale(in)->characteristic_length == characteristic_length(plate()));
}

BOOST_AUTO_TEST_CASE(a_plate_without_stiffness_is_an_error) {
  PlateInput in = plate();
  in.youngs_modulus = 0.0;
  BOOST_CHECK_THROW((void)characteristic_length(in), ContractViolation);
}

BOOST_AUTO_TEST_SUITE_END()
