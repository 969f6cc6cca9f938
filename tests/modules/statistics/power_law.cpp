// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/power_law.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "brash/statistics/random.hpp"

namespace {

using namespace brash::statistics;
using Samples = std::vector<double>;
using boost::test_tools::tolerance;

/// A grid of two inputs.
const Samples kThickness{0.4, 0.4, 0.4, 0.8, 0.8, 0.8, 1.2, 1.2, 1.2}, kSpeed{1, 2, 4, 1, 2, 4, 1, 2, 4};

/// 3e5 h^1.3 v^0.4, scattered by `scatter` in its logarithm.
Samples with_scatter(double scatter, RandomStream& stream) {
  Samples values;
  for (std::size_t i = 0; i < kSpeed.size(); ++i)
    values.push_back(3e5 * std::pow(kThickness[i], 1.3) * std::pow(kSpeed[i], 0.4) *
                     std::exp(scatter * stream.normal()));
  return values;
}

bool holds(const Interval& interval, double value) { return interval.lower <= value && value <= interval.upper; }

BOOST_AUTO_TEST_CASE(a_power_law_without_scatter_is_found) {
  RandomStream stream(1, "exact", 0, "power law");
  const PowerLaw law = fit_power_law({kThickness, kSpeed}, with_scatter(0.0, stream)).value();
  BOOST_TEST(law.factor.value == 3e5, tolerance(1e-10));
  BOOST_TEST(law.powers[0].value == 1.3, tolerance(1e-10));
  BOOST_TEST(law.powers[1].value == 0.4, tolerance(1e-10));
  BOOST_TEST(law.spread < 1e-12);
}

BOOST_AUTO_TEST_CASE(intervals_of_one_power_are_student_s) {
  // ln y over ln x = 0, 1, 2, 3 is 0, 1, 3, 4: slope 1.4, standard error sqrt(0.2/2/5), t(2) = 4.302653.
  const double e = std::exp(1.0);
  const PowerLaw law = fit_power_law({{1.0, e, e * e, e * e * e}}, Samples{1.0, e, e * e * e, e * e * e * e}).value();
  BOOST_TEST(law.powers[0].value == 1.4, tolerance(1e-12));
  BOOST_TEST(law.powers[0].interval.upper == 1.4 + 4.302653 * std::sqrt(0.02), tolerance(1e-6));
  BOOST_TEST(law.spread == std::sqrt(0.1), tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(intervals_cover_as_often_as_they_say) {
  constexpr int kSamples = 1000;
  int factor = 0, thickness = 0, speed = 0;
  for (std::uint64_t r = 0; r < kSamples; ++r) {
    RandomStream stream(1, "coverage", r, "power law");
    const PowerLaw law = fit_power_law({kThickness, kSpeed}, with_scatter(0.1, stream)).value();
    factor += holds(law.factor.interval, 3e5);
    thickness += holds(law.powers[0].interval, 1.3);
    speed += holds(law.powers[1].interval, 0.4);
  }
  const double allowed = 3.0 * std::sqrt(0.0475 / kSamples);
  for (const int covered : {factor, thickness, speed})
    BOOST_TEST(std::abs(covered / static_cast<double>(kSamples) - 0.95) < allowed);
}

BOOST_AUTO_TEST_CASE(inputs_that_determine_no_law_are_refused) {
  const Samples values{1.0, 2.0, 3.0, 4.0};
  BOOST_TEST(!fit_power_law({{1, 2, 3, 4}, {5, 5, 5, 5}}, values));      // a constant input
  BOOST_TEST(!fit_power_law({{1, 2, 3, 4}, {2, 4, 6, 8}}, values));      // two that rise together
  BOOST_TEST(!fit_power_law({{1, 2, 3}, {1, 3, 2}}, Samples{1, 2, 3}));  // as many values as terms
  BOOST_TEST(fit_power_law({{1, 2, 3, 4}, {1, 3, 2, 5}}, values).has_value());
}

}  // namespace
