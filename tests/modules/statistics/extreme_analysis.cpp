// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/extreme_analysis.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "brash/core/contract.hpp"
#include "brash/statistics/random.hpp"
#include "brash/statistics/summary.hpp"

namespace {

using namespace brash::statistics;
using boost::test_tools::tolerance;

/// A sawtooth of cycles of 1 s whose peaks are exponential above 100.
struct Sawtooth {
  History history;
  EvenHistory even;
  double memory = 0.0;

  explicit Sawtooth(int cycles, double limit = 1e9, std::uint64_t replicate = 0) {
    RandomStream stream(1, "extremes", replicate, "peaks");
    constexpr int kSamples = 20;
    for (int c = 0; c < cycles; ++c) {
      const double peak = 100.0 - 40.0 * std::log(1.0 - stream.uniform());
      for (int i = 1; i <= kSamples; ++i) {
        history.times.push_back(0.05 * static_cast<double>(history.times.size()));
        history.values.push_back(std::min(limit, 20.0 + (peak - 20.0) * i / kSamples));
      }
    }
    even = make_even(history);
    memory = summarise(history, even).autocorrelation_time;
  }
  ExtremeRecord record() const { return {&history, &even, memory}; }
};

ExtremeAnalysis analyse(const Sawtooth& load, const ExtremeSettings& settings) {
  GoodnessOfFit goodness;
  return analyse_extremes(extreme_values({load.record()}, settings), settings, goodness);
}

ExtremeSettings for_period(double return_period, double block = 0.0) {
  ExtremeSettings settings;
  settings.return_period = return_period;
  settings.block = block;
  return settings;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

BOOST_AUTO_TEST_SUITE(extreme_analysis)

BOOST_AUTO_TEST_CASE(a_long_record_gets_one_recommended_level_near_the_true_one) {
  const Sawtooth load(1000);
  const ExtremeAnalysis analysis = analyse(load, for_period(3000.0));
  BOOST_TEST(analysis.values.cycle == 1.0, tolerance(0.01));
  BOOST_TEST_REQUIRE(analysis.recommended.has_value());
  const Estimate level = *analysis.of(*analysis.recommended).level;
  const double truth = 100.0 + 40.0 * std::log(3000.0);
  BOOST_TEST(level.interval.lower < truth);
  BOOST_TEST(level.interval.upper > truth);
  BOOST_TEST(level.interval.lower < level.value);
  BOOST_TEST(level.value < level.interval.upper);
  BOOST_TEST(contains(analysis.reason, "show the shape of the tail"));
}

BOOST_AUTO_TEST_CASE(a_minute_does_not_answer_for_an_hour) {
  const Sawtooth load(60);
  ExtremeSettings settings = for_period(3600.0);
  const ExtremeAnalysis refused = analyse(load, settings);
  BOOST_TEST(!refused.recommended.has_value());
  BOOST_TEST(contains(refused.reason, "the return period is 60 times the record, and 30 times is the most"));
  for (const ExtremeEstimate& e : refused.estimates) BOOST_TEST(!e.level.has_value());
  settings.extrapolate = true;
  const ExtremeAnalysis marked = analyse(load, settings);
  BOOST_TEST_REQUIRE(marked.recommended.has_value());
  BOOST_TEST(contains(marked.warnings.at(0), "the level rests on the law more than on data"));
}

BOOST_AUTO_TEST_CASE(a_record_with_few_events_gets_no_level) {
  const ExtremeAnalysis analysis = analyse(Sawtooth(15), for_period(30.0));
  BOOST_TEST(!analysis.recommended.has_value());
  BOOST_TEST(contains(analysis.reason, "load events in 15 s, and 20 are the fewest: about 5"));
  for (const ExtremeEstimate& e : analysis.estimates) BOOST_TEST(!e.fit.has_value());
}

BOOST_AUTO_TEST_CASE(the_rule_that_a_short_record_fails_is_named) {
  const std::string reason = analyse(Sawtooth(25), for_period(400.0)).reason;
  BOOST_TEST(
      contains(reason, "separate peaks over the threshold do not show the shape of the tail, 10 blocks or 30 peaks"));
}

BOOST_AUTO_TEST_CASE(a_record_of_the_length_that_a_short_one_asks_for_suffices) {
  for (const int cycles : {15, 25, 49}) {
    const std::string reason = analyse(Sawtooth(cycles), for_period(400.0)).reason;
    const std::string::size_type at = reason.find("about ");
    BOOST_TEST_REQUIRE(at != std::string::npos, reason);
    const int asked = static_cast<int>(std::ceil(std::stod(reason.substr(at + 6))));
    BOOST_TEST(asked < 70);
    const ExtremeAnalysis enough = analyse(Sawtooth(asked), for_period(400.0));
    BOOST_TEST(enough.values.maxima.size() >= 10U);
    BOOST_TEST(enough.of(Law::kGev).fit.has_value());
    BOOST_TEST(!contains(enough.reason, "are needed"));
  }
}

BOOST_AUTO_TEST_CASE(a_block_holds_load_cycles) {
  const Sawtooth load(200);
  BOOST_TEST(analyse(load, for_period(500.0)).values.block >= 5.0 * 0.99);
  const ExtremeAnalysis short_blocks = analyse(load, for_period(500.0, 0.5));
  BOOST_TEST(contains(short_blocks.of(Law::kGumbel).refusal, "a block of 0.5 s is shorter than the load cycle of 1"));
  BOOST_TEST(!short_blocks.of(Law::kGev).level.has_value());
}

BOOST_AUTO_TEST_CASE(a_clipped_sensor_gets_no_recommendation) {
  const ExtremeAnalysis analysis = analyse(Sawtooth(300, 130.0), for_period(600.0));
  BOOST_TEST(!analysis.recommended.has_value());
  BOOST_TEST(analysis.reason == "the largest loads are clipped");
  BOOST_TEST(contains(analysis.warnings.back(), "the largest value, 130: the sensor seems to clip"));
}

BOOST_AUTO_TEST_CASE(a_load_that_acts_downwards_is_told_to_change_its_sign) {
  BOOST_TEST(acts_downwards(-3.0, -8.0, 5.0));
  BOOST_TEST(!acts_downwards(-3.0, -8.0, 9.0));  // its upper end is the larger one
  BOOST_TEST(!acts_downwards(3.0, -8.0, 5.0));
  BOOST_TEST(acts_downwards(-3.0, -8.0, -1.0));
  BOOST_TEST(!acts_downwards(0.0, -1.0, 1.0));
  Sawtooth load(300);
  BOOST_TEST(analyse(load, for_period(600.0)).warnings.empty());
  for (double& value : load.history.values) value = -value;
  BOOST_TEST(analyse(load, for_period(600.0)).warnings.at(0) == kNegativeMean);
}

BOOST_AUTO_TEST_CASE(a_bounded_load_gets_no_level_from_pareto) {
  Sawtooth load(200);
  RandomStream stream(1, "extremes", 0, "uniform");
  for (int c = 0; c < 200; ++c) {
    const double peak = 100.0 + 200.0 * stream.uniform();
    for (int i = 0; i < 20; ++i)
      load.history.values[static_cast<std::size_t>(20 * c + i)] = 20.0 + (peak - 20.0) * (i + 1) / 20.0;
  }
  load.even = make_even(load.history);
  const ExtremeAnalysis analysis = analyse(load, for_period(800.0));
  BOOST_TEST(!analysis.of(Law::kPareto).level.has_value());
  BOOST_TEST(contains(analysis.of(Law::kPareto).refusal, "the load seems bounded"));
}

BOOST_AUTO_TEST_CASE(replicates_are_pooled_without_blocks_across_them) {
  const Sawtooth first(101, 1e9, 1), second(101, 1e9, 2);
  const ExtremeSettings settings = for_period(400.0, 10.0);
  const ExtremeValues values = extreme_values({first.record(), second.record()}, settings);
  BOOST_TEST(values.maxima.size() == 20U);  // ten whole blocks in each of 101 s
  BOOST_TEST(values.duration == 202.0, tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(blocks_of_an_uneven_record_are_cut_by_time) {
  // A load that is its time: 100 s in steps of 0.05 s, then 100 s in steps of 0.2 s.
  History history;
  for (int i = 0; i < 2000; ++i) history.times.push_back(0.05 * i);
  for (int i = 0; i < 500; ++i) history.times.push_back(100.0 + 0.2 * i);
  history.values = history.times;
  const EvenHistory even = make_even(history);
  BOOST_TEST_REQUIRE(!even.sampling.even);
  BOOST_TEST_REQUIRE(even.sampling.gaps.empty());
  const std::vector<double> maxima = extreme_values({{&history, &even, 1.0}}, for_period(400.0, 15.0)).maxima;
  BOOST_TEST_REQUIRE(maxima.size() == 13U);  // whole blocks of 15 s in 200 s
  for (std::size_t i = 0; i < maxima.size(); ++i) {
    const double end = 15.0 * (static_cast<double>(i) + 1.0);
    BOOST_TEST(maxima[i] < end);
    BOOST_TEST(maxima[i] > end - 0.21);  // the last sample before the end
  }
}

BOOST_AUTO_TEST_CASE(high_thresholds_agree_on_the_shape) {
  const Sawtooth load(2000);
  const ExtremeSettings settings = for_period(4000.0);
  const auto fits = threshold_stability(extreme_values({load.record()}, settings), 4000.0);
  BOOST_TEST_REQUIRE(fits.size() >= 5U);
  for (std::size_t i = 1; i < fits.size(); ++i) {
    BOOST_TEST(fits[i].threshold > fits[i - 1].threshold);
    BOOST_TEST(fits[i].peaks < fits[i - 1].peaks);
  }
  // Peaks are exponential above 100: the second threshold is above.
  BOOST_CHECK_SMALL(fits[1].shape, 0.15);  // four errors of 1/sqrt(900)
}

BOOST_AUTO_TEST_SUITE_END()
