// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/hydrodynamics/added_mass.hpp"

using namespace brash;
using hydrodynamics::entrained_by_half;
using hydrodynamics::EntrainedWater;

BOOST_AUTO_TEST_CASE(half_a_ball_moves_half_its_volume_and_turns_without_the_water) {
  const EntrainedWater water = entrained_by_half({2.0, 2.0, 2.0});
  const double volume = 2.0 / 3.0 * kPi * 8.0;
  for (const double along : {water.along.x, water.along.y, water.along.z})
    BOOST_TEST(along == 0.5 * volume, boost::test_tools::tolerance(1e-12));
  BOOST_TEST((water.about == Vec3{}));
}

BOOST_AUTO_TEST_CASE(prolate_ellipsoids_have_lamb_s_coefficients_in_elementary_functions) {
  // Lamb 1932, art. 114 and 115: with the eccentricity e, in logarithms in place of elliptic integrals.
  for (const double ratio : {1.2, 1.5, 2.0, 5.0, 10.0}) {
    const double e2 = 1.0 - 1.0 / (ratio * ratio), e = std::sqrt(e2), log = std::log((1.0 + e) / (1.0 - e));
    const double alpha = 2.0 * (1.0 - e2) / (e2 * e) * (0.5 * log - e);
    const double beta = 1.0 / e2 - (1.0 - e2) / (2.0 * e2 * e) * log, apart = beta - alpha;
    const double about = e2 * e2 * apart / ((2.0 - e2) * (2.0 * e2 - (2.0 - e2) * apart));
    const double volume = 2.0 / 3.0 * kPi * ratio, about_mass = 0.2 * volume * (ratio * ratio + 1.0);
    const EntrainedWater water = entrained_by_half({ratio, 1.0, 1.0});
    // The closed form loses digits to small e, to the fifth power.
    BOOST_TEST(water.along.x / volume == alpha / (2.0 - alpha), boost::test_tools::tolerance(1e-11));
    BOOST_TEST(water.along.z / volume == beta / (2.0 - beta), boost::test_tools::tolerance(1e-11));
    BOOST_TEST(water.about.y / about_mass == about, boost::test_tools::tolerance(1e-11));
    BOOST_TEST(water.about.x == 0.0);
  }
}

BOOST_AUTO_TEST_CASE(the_axes_of_an_ellipsoid_have_no_order) {
  const EntrainedWater one = entrained_by_half({5.0, 2.0, 1.0}), other = entrained_by_half({2.0, 1.0, 5.0});
  BOOST_TEST(one.along.x == other.along.z, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(one.about.x == other.about.z, boost::test_tools::tolerance(1e-10));
  BOOST_TEST(one.about.z == other.about.y, boost::test_tools::tolerance(1e-10));
}
