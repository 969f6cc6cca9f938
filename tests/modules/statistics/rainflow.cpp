// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/rainflow.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <map>
#include <vector>

#include "brash/core/contract.hpp"

namespace {

using namespace brash::statistics;
using boost::test_tools::tolerance;
using Samples = std::vector<double>;

std::map<double, double> counts(const Samples& samples) {
  std::map<double, double> by_range;
  for (const Cycle& cycle : rainflow(samples)) by_range[cycle.range] += cycle.count;
  return by_range;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(rainflow_counting)

BOOST_AUTO_TEST_CASE(the_example_of_the_standard_is_counted_as_there) {
  // ASTM E1049-85, Fig. 6: reversals A to I.
  const std::map<double, double> expected{{3, 0.5}, {4, 1.5}, {6, 0.5}, {8, 1.0}, {9, 0.5}};
  BOOST_TEST((counts({-2, 1, -3, 5, -1, 3, -4, 4, -2}) == expected));
}

BOOST_AUTO_TEST_CASE(samples_between_reversals_change_nothing) {
  const std::map<double, double> expected{{3, 0.5}, {4, 1.5}, {6, 0.5}, {8, 1.0}, {9, 0.5}};
  BOOST_TEST((counts({-2, -2, 0, 1, 1, -1, -3, 2, 5, 5, 0, -1, 3, -4, -4, 0, 4, 1, -2}) == expected));
}

BOOST_AUTO_TEST_CASE(a_constant_history_has_no_cycles) {
  BOOST_TEST(rainflow(Samples{2, 2, 2}).empty());
  BOOST_TEST(rainflow(Samples{}).empty());
}

BOOST_AUTO_TEST_CASE(a_sinusoid_is_equivalent_to_itself) {
  Samples wave;
  for (int i = 0; i < 1000; ++i) wave.push_back(i % 2 == 0 ? -30.0 : 30.0);
  for (const double m : {1.0, 3.0, 10.0}) {
    const double of_wave = damage(rainflow(wave), m);
    // 999 half cycles of range 60 in 499.5 s.
    BOOST_TEST(damage_equivalent_load(of_wave, m, 499.5, 1.0) == 60.0, tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(the_damage_of_the_stretches_is_all_damage) {
  const Samples load{0, 5, 1, 7, 2, 9, 0, 4, 1, 8, 3, 6, 0};
  const auto cycles = rainflow(load);
  const StretchDamages stretches = damage_by_stretch(cycles, 3.0, load.size(), 4);
  BOOST_TEST_REQUIRE(stretches.damages.size() == 3U);
  BOOST_TEST(stretches.damages[0] + stretches.damages[1] + stretches.damages[2] == damage(cycles, 3.0),
             tolerance(1e-12));
  BOOST_TEST(stretches.lengths == (Samples{4, 4, 5}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(damage_of_ranges_that_the_record_may_lack_is_told) {
  std::vector<Cycle> even, heavy;
  for (int i = 0; i < 200; ++i) {
    const double q = (i + 0.5) / 200.0;
    even.push_back({100.0 + q, 0.0, 1.0, 0});
    heavy.push_back({100.0 * std::pow(q, -0.5), 0.0, 1.0, 0});  // a Pareto tail of shape 0.5
  }
  BOOST_TEST(unseen_damage(even, 3.0) < kMostUnseen);
  BOOST_TEST(unseen_damage(heavy, 3.0) == 1.0);  // its third moment has no bound
}

BOOST_AUTO_TEST_CASE(the_largest_damage_of_an_exponential_tail_holds_the_true_one) {
  // Excesses e over 100: a moment E[(100 + 40 e)^m] is a sum over k of binomials times k!.
  const double m = 5.0, truth = [] {
    double sum = 0.0, term = 1.0;
    for (int k = 0; k <= 5; ++k) {
      sum += term;
      term *= (5.0 - k) * 0.4;
    }
    return 1e10 * sum;
  }();
  int held = 0;
  for (std::uint64_t r = 0; r < 200; ++r) {
    RandomStream stream(1, "rainflow", r, "exponential");
    std::vector<Cycle> cycles;
    for (int i = 0; i < 100; ++i) {
      const double range = 100.0 - 40.0 * std::log(stream.uniform() + 0x1p-49);
      // As two halves, as in a sawtooth.
      for (int half = 0; half < 2; ++half) cycles.push_back({range, 0.0, 0.5, 0});
    }
    held += largest_damage_ratio(cycles, m, 0.95) * damage(cycles, m) >= 100.0 * truth ? 1 : 0;
  }
  // 97.5 % of the upper ends lie above the truth; three errors of the count below.
  BOOST_TEST(held >= 200 * 0.975 - 3.0 * std::sqrt(200 * 0.975 * 0.025));
}

BOOST_AUTO_TEST_CASE(a_tail_heavier_than_exponential_has_no_largest_damage) {
  std::vector<Cycle> heavy;
  for (int i = 0; i < 200; ++i) heavy.push_back({100.0 * std::pow((i + 0.5) / 200.0, -0.5), 0.0, 1.0, 0});
  BOOST_TEST(std::isinf(largest_damage_ratio(heavy, 3.0, 0.95)));
  BOOST_TEST(std::isinf(largest_damage_ratio(std::vector<Cycle>(5, {1.0, 0.0, 1.0, 0}), 3.0, 0.95)));
}

BOOST_AUTO_TEST_CASE(the_interval_of_equal_stretches_is_a_point) {
  RandomStream stream(1, "rainflow", 0, "bootstrap");
  const Interval interval = damage_rate_interval({Samples(10, 6.0), Samples(10, 3.0)}, 0.95, stream);
  BOOST_TEST(interval.lower == 2.0);
  BOOST_TEST(interval.upper == 2.0);
  BOOST_CHECK_THROW(damage_rate_interval({Samples(1, 6.0), Samples(1, 3.0)}, 0.95, stream), brash::ContractViolation);
}

BOOST_AUTO_TEST_SUITE_END()
