// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "brash/plate/plate.hpp"

namespace plate = brash::plate;

namespace {

/// A parabola in the moment, uniform membrane stress.
plate::UnitProfiles parabola() {
  plate::UnitProfiles profiles;
  for (int i = 0; i <= 20; ++i) {
    const double x = 0.1 * i;
    profiles.station.push_back(x);
    profiles.bending.push_back({1.0 - (x - 0.93) * (x - 0.93), -0.5, 0.0});
    profiles.normal.push_back({-1.0, 0.25, 0.0});
    profiles.tangential.push_back({0.0, 0.0, 0.0});
    profiles.deflection.push_back(0.0);
  }
  profiles.root_bending = 2.0;
  profiles.root_normal = 3.0;
  profiles.root_tangential = 5.0;
  return profiles;
}

}  // namespace

// A parabola through three points is exact for a parabola, up to rounding.
BOOST_AUTO_TEST_CASE(the_peak_of_a_parabola_between_stations_is_found_exactly) {
  const auto response = plate::respond(parabola(), 0.1, 0.5, 0.0);
  BOOST_TEST(response.lbreak_over_lc == 0.93, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(response.sigma_over_p == 6.0 * 0.5 / 0.1 - 1.0, boost::test_tools::tolerance(1e-12));
}

// 30 (1 - d^2) - 1 = 0.99 * 29 at d = 0.0983; straight lines between stations 0.1 apart err by at most
// 60 * 0.1^2 / 8 = 0.075 in stress, which at the mean slope of that interval (4.8) is 0.016 in place.
BOOST_AUTO_TEST_CASE(the_plateau_is_where_the_stress_exceeds_99_percent_of_the_peak) {
  const auto response = plate::respond(parabola(), 0.1, 0.5, 0.0);
  BOOST_TEST(std::abs(response.plateau_from - (0.93 - 0.0983)) < 0.016);
  BOOST_TEST(std::abs(response.plateau_to - (0.93 + 0.0983)) < 0.016);
}

BOOST_AUTO_TEST_CASE(the_radial_stress_is_that_of_the_other_surface_at_B) {
  const auto response = plate::respond(parabola(), 0.1, 0.5, 0.0);
  BOOST_TEST(response.sigma_radial_over_p == 30.0 * 0.5 + 0.25, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(the_root_bound_adds_the_three_loads) {
  const auto response = plate::respond(parabola(), 0.1, 0.5, -0.2);
  BOOST_TEST(response.sigma_root_over_p == 30.0 * 2.0 + 3.0 + 0.2 * 5.0, boost::test_tools::tolerance(1e-12));
}

// Shear alone: the principal stress of pure shear is its size.
BOOST_AUTO_TEST_CASE(friction_enters_the_principal_stress) {
  auto profiles = parabola();
  for (auto& t : profiles.tangential) t.xy = 2.0;
  for (auto& t : profiles.normal) t = {};
  const auto response = plate::respond(profiles, 0.1, 0.0, -0.5);
  BOOST_TEST(response.sigma_over_p == 1.0, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_cone_that_breaks_upwards_gives_the_same_stress_on_the_other_surface) {
  const auto down = plate::respond(parabola(), 0.1, 0.5, 0.1);
  const auto up = plate::respond(parabola(), 0.1, -0.5, 0.1);
  BOOST_TEST(down.sigma_over_p == up.sigma_over_p);
  BOOST_TEST(down.sigma_radial_over_p == up.sigma_radial_over_p);
}
