// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/shared_tail.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "brash/statistics/random.hpp"

namespace {

using namespace brash::statistics;
using boost::test_tools::tolerance;

constexpr double kRecord = 100.0;  // [s]

/// The excess of Pareto's law that a probability exceeds.
double excess(double probability, double scale, double shape) {
  return shape == 0.0 ? -scale * std::log(probability) : scale * (std::pow(probability, -shape) - 1.0) / shape;
}

/// Records of 100 s with ten peaks over 100 each.
StatePeaks state_of(double scale, double shape, int records, RandomStream& stream) {
  StatePeaks state{100.0, {}, std::vector<double>(static_cast<std::size_t>(records), kRecord)};
  for (int r = 0; r < records; ++r) {
    state.over.emplace_back();
    for (int i = 0; i < 10; ++i) state.over.back().push_back(100.0 + excess(1.0 - stream.uniform(), scale, shape));
  }
  return state;
}

StatePeaks state_of(double scale, double shape, int records) {
  RandomStream stream(1, "shared tail", 0, "peaks");
  return state_of(scale, shape, records, stream);
}

std::vector<double> all_of(const StatePeaks& state) {
  std::vector<double> all;
  for (const auto& record : state.over) all.insert(all.end(), record.begin(), record.end());
  return all;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(shared_tail)

BOOST_AUTO_TEST_CASE(one_state_has_the_fit_and_the_level_of_paretos_law) {
  for (const double shape : {-0.2, 0.0, 0.3}) {
    StatePeaks state = state_of(40.0, shape, 12);
    state = {state.threshold, {all_of(state)}, {12 * kRecord}};  // one record, which is not resampled
    const auto tail = SharedTail::fit({state});
    const auto law = fit_generalised_pareto(all_of(state), 100.0);
    BOOST_REQUIRE(tail.has_value());
    BOOST_REQUIRE(law.has_value());
    BOOST_TEST(tail->shape() == law->shape, tolerance(1e-3));  // of a search to 1e-5
    BOOST_TEST(tail->scale(0) == law->scale, tolerance(1e-4));
    const Estimate expected = return_level(*law, 12 * kRecord, 1e5);
    const auto found = tail->level({{1e5}, 1.0});
    BOOST_REQUIRE(found.has_value());
    BOOST_TEST(found->value == expected.value, tolerance(1e-3));
    // Its interval adds the error of the rate in another way, and takes Student's limit.
    BOOST_TEST(found->interval.lower == expected.interval.lower, tolerance(0.03));
    BOOST_TEST(found->interval.upper == expected.interval.upper, tolerance(0.08));
  }
}

BOOST_AUTO_TEST_CASE(a_state_in_two_halves_is_the_state) {
  const StatePeaks whole = state_of(40.0, 0.1, 12);
  StatePeaks first = whole, second = whole;
  first.over.resize(6);
  first.durations.resize(6);
  second.over.erase(second.over.begin(), second.over.begin() + 6);
  second.durations.resize(6);
  first.over = second.over;  // the same peaks twice, so that each half has the scale of both
  StatePeaks both = first;
  both.over.insert(both.over.end(), second.over.begin(), second.over.end());
  both.durations.resize(12, kRecord);
  const auto halves = SharedTail::fit({first, second}), one = SharedTail::fit({both});
  BOOST_TEST(halves->level({{500.0, 500.0}, 0.1})->value == one->level({{1000.0}, 0.1})->value, tolerance(1e-3));
  BOOST_TEST(halves->one_shape().p_value == 1.0, tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(states_add_their_exceedances) {
  RandomStream stream(1, "shared tail", 0, "three states");
  const auto tail =
      SharedTail::fit({state_of(40.0, 0.1, 8, stream), state_of(80.0, 0.1, 8, stream), state_of(20.0, 0.1, 8, stream)});
  const std::vector<double> seconds{1e6, 1e4, 1e7};
  for (const double expected : {1.0, 0.02, 1e-4}) {
    const double level = tail->level({seconds, expected})->value;
    double sum = 0.0;
    for (const double share : tail->shares(level, seconds)) sum += share;
    BOOST_TEST(sum == expected, tolerance(1e-6));  // of a root to 1e-10 of the level
  }
  BOOST_TEST(!tail->level({{1.0, 1.0, 1.0}, 1.0}).has_value());  // 0.1 peaks a second
}

BOOST_AUTO_TEST_CASE(a_state_of_another_shape_is_found) {
  RandomStream stream(1, "shared tail", 0, "shapes");
  const StatePeaks light = state_of(40.0, -0.3, 20, stream), same = state_of(70.0, -0.3, 20, stream),
                   heavy = state_of(40.0, 0.4, 20, stream);
  BOOST_TEST(SharedTail::fit({light, same})->one_shape().p_value > 0.05);
  BOOST_TEST(SharedTail::fit({light, heavy})->one_shape().p_value < 1e-4);
}

BOOST_AUTO_TEST_CASE(few_peaks_are_refused) {
  StatePeaks state = state_of(40.0, 0.0, 1);
  const auto tail = SharedTail::fit({state});
  BOOST_REQUIRE(!tail.has_value());
  BOOST_TEST(tail.error().reason == "all states together have 10 peaks over their thresholds, and 20 are the fewest");
}

// The load of fifty years from records of minutes: the interval holds the truth in about 95 of 100 campaigns. Four
// standard errors of 200 campaigns are 6 points.
BOOST_AUTO_TEST_CASE(intervals_of_far_levels_hold_the_truth) {
  constexpr int kCampaigns = 200;
  const std::vector<double> seconds{1e6, 3e5, 1e5}, scales{40.0, 60.0, 90.0};
  constexpr double kExpected = 0.02;
  for (const double shape : {-0.2, 0.0, 0.15}) {
    const auto number = [&](double x) {
      double sum = 0.0;
      for (std::size_t i = 0; i < scales.size(); ++i) {
        const double t = 1.0 + shape * (x - 100.0) / scales[i];
        sum += 0.1 * seconds[i] *
               (shape == 0.0 ? std::exp(-(x - 100.0) / scales[i])
                : t > 0.0    ? std::pow(t, -1.0 / shape)
                             : 0.0);
      }
      return sum;
    };
    double low = 100.0, high = 1e5;
    for (int i = 0; i < 80; ++i) (number(0.5 * (low + high)) > kExpected ? low : high) = 0.5 * (low + high);
    int held = 0;
    for (int c = 0; c < kCampaigns; ++c) {
      RandomStream stream(1, "shared tail", static_cast<std::uint64_t>(c), "campaign");
      std::vector<StatePeaks> states;
      for (const double scale : scales) states.push_back(state_of(scale, shape, 6, stream));
      const Interval interval = SharedTail::fit(std::move(states))->level({seconds, kExpected})->interval;
      held += interval.lower <= low && low <= interval.upper ? 1 : 0;
    }
    BOOST_TEST_MESSAGE("shape " << shape << ": " << held << " of " << kCampaigns);
    BOOST_TEST(held >= 178);
  }
}

// Each record has the same peaks ten times: there are a tenth as many independent ones.
BOOST_AUTO_TEST_CASE(peaks_that_depend_on_each_other_widen_the_intervals) {
  RandomStream stream(1, "shared tail", 0, "dependent");
  const StatePeaks once = state_of(40.0, 0.0, 60, stream);
  StatePeaks repeated = once;
  for (auto& record : repeated.over) std::ranges::fill(record, record.front());
  const auto few = SharedTail::fit({repeated}), many = SharedTail::fit({once});
  BOOST_TEST(many->dispersion() < 2.0);
  BOOST_TEST(few->dispersion() == 10.0, tolerance(0.5));  // of the variance of one sample of 60
}

BOOST_AUTO_TEST_SUITE_END()
