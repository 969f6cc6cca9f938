// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/summary.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "brash/core/contract.hpp"
#include "brash/statistics/moments.hpp"
#include "brash/statistics/quantile.hpp"
#include "brash/statistics/random.hpp"

namespace {

using namespace brash::statistics;

/// x_i = phi x_{i-1} + e_i, stationary from the start, variance 1; tau = (1 + phi) / (1 - phi) / 2 samples.
std::vector<double> first_order(double phi, std::size_t n, std::uint64_t replicate) {
  RandomStream stream(1, "first-order", replicate, "noise");
  std::vector<double> x(n);
  x[0] = stream.normal();
  for (std::size_t i = 1; i < n; ++i) x[i] = phi * x[i - 1] + std::sqrt(1.0 - phi * phi) * stream.normal();
  return x;
}

double coverage(double phi, std::size_t n, int replicates, double* mean_tau = nullptr) {
  int covered = 0;
  double tau = 0.0;
  for (int r = 0; r < replicates; ++r) {
    const Summary s = summarise(first_order(phi, n, static_cast<std::uint64_t>(r)), 1.0);
    covered += s.mean_95.lower <= 0.0 && 0.0 <= s.mean_95.upper ? 1 : 0;
    tau += s.autocorrelation_time;
  }
  if (mean_tau) *mean_tau = tau / replicates;
  return static_cast<double>(covered) / replicates;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(summary)

BOOST_AUTO_TEST_CASE(moments_and_quantiles_of_a_short_history_are_those_of_hand_calculation) {
  const std::vector<double> x{4.0, 1.0, 3.0, 2.0, 10.0};
  const Summary s = summarise(x, 0.1);
  const auto close = boost::test_tools::tolerance(1e-14);  // rounding
  BOOST_TEST(s.n == 5U);
  BOOST_TEST(s.mean == 4.0, close);
  BOOST_TEST(s.standard_deviation == std::sqrt(50.0 / 4.0), close);
  BOOST_TEST(s.skewness == (180.0 / 5.0) / std::pow(10.0, 1.5), close);  // 0, -27, -1, -8, 216
  BOOST_TEST(s.excess_kurtosis == (0.0 + 81.0 + 1.0 + 16.0 + 1296.0) / 5.0 / 100.0 - 3.0, close);
  BOOST_TEST(s.minimum == 1.0);
  BOOST_TEST(s.maximum == 10.0);
  BOOST_TEST(s.quantile_1 == 1.04, close);
  BOOST_TEST(s.quantile_50 == 3.0, close);
  BOOST_TEST(s.quantile_95 == 4.0 + 0.8 * 6.0, close);
  BOOST_TEST(s.quantile_99 == 4.0 + 0.96 * 6.0, close);
}

BOOST_AUTO_TEST_CASE(the_list_of_statistics_has_each_once_and_says_which_change_sign_with_the_load) {
  std::vector<double> x = first_order(0.5, 400, 3), turned = x;
  for (std::size_t i = 0; i < x.size(); ++i) turned[i] = -(x[i] = std::exp(x[i]));
  const Summary a = summarise(x, 0.1), b = summarise(turned, 0.1);
  std::set<std::string> names;
  std::size_t bytes = sizeof(a.n);
  Summary::visit([&](const Statistic& of, auto member) {
    BOOST_TEST(names.insert(of.name).second, of.name);
    bytes += sizeof(a.*member);
    if constexpr (std::is_same_v<decltype(member), double Summary::*>) {
      const double in_a = a.*member, in_b = b.*member;
      if (!of.turns) BOOST_TEST(in_b == in_a, boost::test_tools::tolerance(1e-9));
    }
  });
  // All members, up to the padding behind the last.
  BOOST_TEST(sizeof(Summary) - bytes < alignof(double));
  for (const char* const name : {"mean", "mean_95", "minimum", "maximum", "skewness", "quantile_99"})
    Summary::visit([&](const Statistic& of, auto) { BOOST_TEST((of.turns || std::string(name) != of.name), name); });
  BOOST_TEST(b.mean == -a.mean, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(b.skewness == -a.skewness, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(b.minimum == -a.maximum);
}

// Longer than a part of the transform: products of two parts count too.
BOOST_AUTO_TEST_CASE(autocorrelations_of_a_long_history_are_sums_of_its_products) {
  const std::size_t n = 600'000;
  std::vector<double> x = first_order(0.999, n, 1);
  double mean = 0.0;
  for (const double value : x) mean += value / static_cast<double>(n);
  for (double& value : x) value -= mean;
  const std::vector<double> rho = autocorrelation(x, 5000);
  const auto sum = [&](std::size_t lag) {
    double products = 0.0;
    for (std::size_t i = 0; i + lag < n; ++i) products += x[i] * x[i + lag];
    return products;
  };
  for (const std::size_t lag : {1U, 700U, 5000U}) BOOST_CHECK_SMALL(rho[lag] - sum(lag) / sum(0), 1e-11);  // rounding
}

BOOST_AUTO_TEST_CASE(equal_weights_may_be_one_number) {
  const std::vector<double> x = first_order(0.5, 1000, 2), weights(1000, 0.3), levels{0.0, 0.1, 0.99, 1.0};
  const Moments all = moments(x, weights), one = moments(x, std::vector{0.3});
  BOOST_TEST(all.mean == one.mean);
  BOOST_TEST(all.variance == one.variance);
  BOOST_TEST(all.skewness == one.skewness);
  BOOST_TEST(quantiles(x, weights, levels) == quantiles(x, std::vector{0.3}, levels), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(quantiles_of_shares_count_each_value_with_its_whole_weight) {
  // A hundred floes of 1 m2 hold a tenth of the area, one of 900 m2 the rest.
  std::vector<double> sizes(100, 1.0), areas(100, 1.0);
  sizes.insert(sizes.begin() + 50, 30.0);
  areas.insert(areas.begin() + 50, 900.0);
  const std::vector<double> levels{0.0, 0.05, 0.1, 0.101, 0.5, 1.0}, wanted{1.0, 1.0, 1.0, 30.0, 30.0, 30.0};
  BOOST_TEST(quantiles_of_shares(sizes, areas, levels) == wanted, boost::test_tools::per_element());
  // Ten weights of a tenth do not sum to one in binary, but each level is still reached by its value.
  const std::vector<double> ten{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, tenths{0.3, 0.8, 0.9, 1.0}, reached{3, 8, 9, 10};
  BOOST_TEST(quantiles_of_shares(ten, std::vector<double>(10, 0.1), tenths) == reached,
             boost::test_tools::per_element());
  BOOST_TEST(quantiles_of_shares(std::vector{7.0}, std::vector{2.0}, std::vector{0.5})[0] == 7.0);
}

BOOST_AUTO_TEST_CASE(a_constant_history_has_no_spread_and_no_correlation) {
  const std::vector<double> x(100, 7.5);
  const Summary s = summarise(x, 0.01);
  BOOST_TEST(s.standard_deviation == 0.0);
  BOOST_TEST(s.skewness == 0.0);
  BOOST_TEST(s.autocorrelation_time >= 0.005);
  BOOST_TEST(s.mean_95.lower == 7.5);
  BOOST_TEST(s.mean_95.upper == 7.5);
}

BOOST_AUTO_TEST_CASE(autocorrelations_equal_their_definition) {
  const std::vector<double> x = first_order(0.7, 137, 0);
  const std::vector<double> rho = autocorrelation(x, 136);
  double mean = 0.0, variance = 0.0;
  for (const double v : x) mean += v / 137.0;
  for (const double v : x) variance += (v - mean) * (v - mean);
  for (std::size_t k = 0; k < 137; ++k) {
    double sum = 0.0;
    for (std::size_t i = 0; i + k < 137; ++i) sum += (x[i] - mean) * (x[i + k] - mean);
    BOOST_CHECK_SMALL(rho[k] - sum / variance, 1e-14);  // rounding of the transform
  }
}

BOOST_AUTO_TEST_CASE(white_noise_has_half_a_step_as_autocorrelation_time) {
  const Summary s = summarise(first_order(0.0, 100000, 0), 0.01);
  BOOST_TEST(s.autocorrelation_time == 0.005, boost::test_tools::tolerance(0.03));  // window 5: 4 errors of sqrt(22/n)
  BOOST_TEST(s.effective_sample_size > 0.97e5);
  BOOST_TEST(s.long_enough);
}

BOOST_AUTO_TEST_CASE(the_autocorrelation_time_of_a_first_order_process_is_found_without_bias) {
  for (const double phi : {0.5, 0.9, 0.98}) {
    const double exact = 0.5 * (1.0 + phi) / (1.0 - phi);
    const auto n = static_cast<std::size_t>(2000.0 * exact);
    double tau = 0.0;
    const int replicates = 20;
    for (int r = 0; r < replicates; ++r) {
      tau += autocorrelation_time(first_order(phi, n, static_cast<std::uint64_t>(r)), 1.0).tau / replicates;
    }
    // Relative error of one estimate sqrt(2 (2 W + 1) / n), W = 5 tau: 0.10; of 20: 0.023. Three of them, plus the
    // truncation bias of the window, 1 %.
    BOOST_TEST(std::abs(tau / exact - 1.0) < 3.0 * 0.023 + 0.01);
  }
}

BOOST_AUTO_TEST_CASE(the_interval_covers_the_mean_in_95_of_100_histories) {
  const int replicates = 2000;
  double tau = 0.0;
  // Histories of 200 autocorrelation times; the standard error of a coverage is sqrt(0.95 x 0.05 / 2000) = 0.5 %. The
  // estimated tau makes the interval miss a little more often, which a margin of 1 % below allows for.
  const double correlated = coverage(0.9, 1900, replicates, &tau);
  BOOST_TEST_MESSAGE("coverage " << correlated << ", mean tau " << tau << " for 9.5");
  BOOST_TEST(correlated > 0.95 - 0.01 - 3.0 * 0.005);
  BOOST_TEST(correlated < 0.95 + 3.0 * 0.005);
  const double white = coverage(0.0, 200, replicates);
  BOOST_TEST_MESSAGE("coverage of white noise " << white);
  BOOST_TEST(white > 0.95 - 0.01 - 3.0 * 0.005);
  BOOST_TEST(white < 0.95 + 3.0 * 0.005);
}

/// A sawtooth of cycles of 1 s on average, every 0.05 s, whose peaks follow a first-order process of 10 s. Mean 1/2.
std::vector<double> slow_sawtooth(double seconds, std::uint64_t replicate) {
  RandomStream stream(1, "slow", replicate, "peaks");
  std::vector<double> x;
  const auto n = static_cast<std::size_t>(seconds / 0.05);
  double state = stream.normal();
  while (x.size() < n) {
    const int samples = std::max(4, static_cast<int>(std::round(20.0 + 6.0 * stream.normal())));
    const double kept = std::exp(-0.05 * samples / 10.0);
    state = kept * state + std::sqrt(1.0 - kept * kept) * stream.normal();
    const double peak = (1.0 + 0.2 * state) * (1.0 + 0.3 * stream.normal());
    for (int i = 0; i < samples; ++i) x.push_back(peak * i / (samples - 1));
  }
  x.resize(n);
  return x;
}

BOOST_AUTO_TEST_CASE(the_interval_allows_for_a_slow_change_of_the_peaks) {
  const int replicates = 100;
  int covered = 0;
  for (int r = 0; r < replicates; ++r) {
    const Summary s = summarise(slow_sawtooth(1000.0, static_cast<std::uint64_t>(r)), 0.05);
    covered += s.mean_95.lower <= 0.5 && 0.5 <= s.mean_95.upper ? 1 : 0;
  }
  BOOST_TEST_MESSAGE("coverage under a slow change " << covered << " %");
  // About 92 %, less three errors. The window of the samples alone closes within a cycle, and covers half.
  BOOST_TEST(covered >= 84);
}

BOOST_AUTO_TEST_CASE(a_record_of_few_load_cycles_keeps_the_time_of_its_samples) {
  for (const double seconds : {8.0, 60.0}) {
    const std::vector<double> x = slow_sawtooth(seconds, 1);
    BOOST_TEST(summarise(x, 0.05).autocorrelation_time == autocorrelation_time(x, 0.05).tau);
  }
}

BOOST_AUTO_TEST_CASE(a_history_shorter_than_its_memory_says_so) {
  std::vector<double> ramp(200);
  for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = static_cast<double>(i);
  BOOST_TEST(!summarise(ramp, 1.0).long_enough);
  BOOST_TEST(!summarise(first_order(0.98, 500, 0), 1.0).long_enough);  // 10 autocorrelation times
}

BOOST_AUTO_TEST_CASE(the_statistics_do_not_depend_on_the_unit_of_the_load) {
  std::vector<double> newtons = first_order(0.8, 3000, 4);
  std::vector<double> shifted = newtons;
  for (double& x : shifted) x = 1e5 + 1e3 * x;
  const Summary a = summarise(newtons, 0.01), b = summarise(shifted, 0.01);
  // The offset of 100 deviations costs two digits.
  BOOST_TEST(b.autocorrelation_time == a.autocorrelation_time, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(b.skewness == a.skewness, boost::test_tools::tolerance(1e-10));
  BOOST_TEST(b.standard_deviation == 1e3 * a.standard_deviation, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(histories_that_are_too_short_or_not_finite_break_the_contract) {
  BOOST_CHECK_THROW(summarise(std::vector<double>{1.0}, 0.1), brash::ContractViolation);
  BOOST_CHECK_THROW(summarise(std::vector<double>{1.0, 2.0}, 0.0), brash::ContractViolation);
  BOOST_CHECK_THROW(summarise(std::vector<double>{1.0, std::numeric_limits<double>::quiet_NaN()}, 0.1),
                    brash::ContractViolation);
}

BOOST_AUTO_TEST_SUITE_END()
