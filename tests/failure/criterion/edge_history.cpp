// SPDX-License-Identifier: GPL-3.0-or-later
// Duhamel's integral over the force of an edge, with responses in closed form.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "brash/failure/edge_motion.hpp"

namespace {

using namespace brash;
using failure::EdgeHistory;

/// The responses of a mass on a spring to a ramp, over t: the step response 1 - cos t decays as exp(-t/5).
struct Series {
  std::vector<double> time, value;
  Series() {
    for (double t = 0.01; t < 60.0; t *= 1.05) {
      time.push_back(t);
      value.push_back(ramp(t) / t);
    }
  }
  static constexpr double kDecay = 0.2;
  /// Integral of 1 - cos t exp(-a t).
  static double ramp(double t) {
    const double a = kDecay, e = std::exp(-a * t);
    return t - (a + e * (std::sin(t) - a * std::cos(t))) / (1.0 + a * a);
  }
};

double deflection(const EdgeHistory& history, const Series& series, double at) {
  return history.weights(series.time, 1.0, at).of(series.value.data(), 1, 1.0);
}

BOOST_AUTO_TEST_CASE(a_force_that_grows_evenly_gives_the_ramp_response) {
  const Series series;
  EdgeHistory history(2.0);
  for (int i = 1; i <= 40; ++i) history.extend(2.0 + 0.1 * i, 0.3 * i, 100.0);
  for (const double at : {6.0, 6.5, 8.0})  // afterwards it goes on growing
    BOOST_TEST(deflection(history, series, at) == 3.0 * Series::ramp(at - 2.0), boost::test_tools::tolerance(1e-4));
}

BOOST_AUTO_TEST_CASE(a_force_that_rises_and_falls_superposes_ramps) {
  const Series series;
  EdgeHistory history(0.0);
  history.extend(1.0, 2.0, 100.0);
  history.extend(1.5, 0.0, 100.0);
  history.extend(4.0, 0.0, 100.0);
  const auto known = [](double t) {
    return 2.0 * Series::ramp(t) - 6.0 * Series::ramp(t - 1.0) + 4.0 * Series::ramp(t - 1.5);
  };
  BOOST_TEST(deflection(history, series, 4.0) == known(4.0), boost::test_tools::tolerance(1e-3));
  BOOST_TEST(history.force() == 0.0);
}

BOOST_AUTO_TEST_CASE(an_old_load_settles_and_its_deflection_stays) {
  const Series series;
  EdgeHistory all(0.0), settled(0.0);
  for (int i = 1; i <= 1500; ++i) {
    const double t = 0.1 * i, force = 5.0 * (1.0 - std::cos(0.1 * t));
    all.extend(t, force, 1e9);
    settled.extend(t, force, series.time.back());
  }
  BOOST_TEST(all.knots().size() == 1501u);
  BOOST_TEST(settled.knots().size() < 620u);
  BOOST_TEST(deflection(settled, series, 150.0) == deflection(all, series, 150.0), boost::test_tools::tolerance(1e-4));
  // The load changes slowly: the deflection is nearly the static one.
  BOOST_TEST(deflection(settled, series, 150.0) == settled.force(), boost::test_tools::tolerance(0.02));
}

BOOST_AUTO_TEST_CASE(without_a_step_there_is_no_deflection) {
  const Series series;
  BOOST_TEST(deflection(EdgeHistory(1.0), series, 1.5) == 0.0);
}

}  // namespace
