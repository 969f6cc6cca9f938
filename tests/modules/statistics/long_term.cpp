// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/long_term.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "brash/statistics/random.hpp"

namespace {

using namespace brash::statistics;
using boost::test_tools::tolerance;

constexpr double kBlock = 200.0;  // [s]

/// A GEV law of the mode 100, the scale 20 and the shape xi, with 60 values of it.
IceState state_of(double xi, double hours) {
  IceState state{{{Law::kGev, 100.0, 20.0, xi}, {}}, 1.0 / kBlock, hours};
  RandomStream stream(1, "long term", 0, "maxima");
  for (int i = 0; i < 60; ++i) state.fit.values.push_back(state.fit.distribution.level(1.0 - stream.uniform()));
  std::ranges::sort(state.fit.values);
  return state;
}

/// Expected exceedances a year of an annual probability.
double expected(double probability) { return -std::log1p(-probability); }

}  // namespace

BOOST_AUTO_TEST_SUITE(long_term)

BOOST_AUTO_TEST_CASE(the_annual_level_of_one_state_is_the_closed_form_of_its_law) {
  for (const double xi : {-0.3, 0.2, 0.8}) {
    const IceState state = state_of(xi, 500.0);
    const double values = 3600.0 * 500.0 / kBlock;
    const LongTerm years({state}, 1e-4);
    for (const double p : {1e-2, 1e-4}) {
      const double share = expected(p) / values;
      const double closed = 100.0 + 20.0 / xi * (std::pow(-std::log1p(-share), -xi) - 1.0);
      BOOST_TEST(years.level(p).value == closed, tolerance(1e-9));  // rounding of a power
    }
  }
}

BOOST_AUTO_TEST_CASE(bounds_of_one_state_are_the_interval_of_its_level) {
  const IceState state = state_of(0.2, 500.0);
  const LongTerm years({state}, 1e-4);
  for (const double p : {1e-2, 1e-4}) {
    const Interval bounds = years.level(p).interval;
    const Interval own = level_with_interval(state.fit, expected(p) * kBlock / (3600.0 * 500.0)).interval;
    BOOST_TEST(bounds.lower == own.lower, tolerance(0.01));  // interpolation, as long_term.cpp says
    BOOST_TEST(bounds.upper == own.upper, tolerance(0.01));
  }
}

BOOST_AUTO_TEST_CASE(the_annual_level_of_several_states_has_the_expected_exceedances) {
  const std::vector<IceState> states{state_of(0.2, 500.0), state_of(-0.3, 3000.0), state_of(0.5, 20.0)};
  const LongTerm years(states, 1e-4);
  for (const double p : {0.5, 1e-2, 1e-4})
    BOOST_TEST(years.exceedances(years.level(p).value) == expected(p), tolerance(1e-8));  // of a root to 1e-10
  // Two equal states last as long as both.
  const LongTerm halves({state_of(0.2, 250.0), state_of(0.2, 250.0)}, 1e-4), whole({state_of(0.2, 500.0)}, 1e-4);
  BOOST_TEST(halves.level(1e-2).value == whole.level(1e-2).value, tolerance(1e-8));
}

BOOST_AUTO_TEST_SUITE_END()
