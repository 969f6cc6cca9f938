// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/sizes.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "brash/core/contract.hpp"
#include "brash/statistics/random.hpp"

namespace {

using namespace brash::statistics;
using Samples = std::vector<double>;
using boost::test_tools::tolerance;

bool holds(const Interval& interval, double value) { return interval.lower <= value && value <= interval.upper; }

/// Covered out of `n_samples`: 95 % +- 3 deviations of a binomial number.
void check_coverage(int covered, int n_samples, double least) {
  BOOST_TEST(covered >= least * n_samples - 3.0 * std::sqrt(0.0475 * n_samples));
  BOOST_TEST(covered <= 0.95 * n_samples + 3.0 * std::sqrt(0.0475 * n_samples));
}

/// A power law of the tail from 10 on, with even sizes from 2 to 10 before it.
Samples with_tail(int n, double exponent, std::uint64_t replicate) {
  RandomStream stream(5, "tail", replicate, "sizes");
  Samples x;
  for (int i = 0; i < n; ++i)
    x.push_back(i % 2 == 0 ? 2.0 + 8.0 * stream.uniform()
                           : 10.0 * std::pow(1.0 - stream.uniform(), 1.0 / (1.0 - exponent)));
  return x;
}

BOOST_AUTO_TEST_CASE(the_log_normal_fit_has_the_moments_of_the_logarithms) {
  Samples sizes;
  for (int i = 1; i <= 20; ++i) sizes.push_back(std::exp(0.1 * i));
  const SizeFit fit = fit_log_normal_sizes(sizes).value();
  BOOST_TEST(fit.scale.value == std::exp(1.05), tolerance(1e-12));
  BOOST_TEST(fit.shape.value == std::sqrt(0.3325), tolerance(1e-12));  // 0.01 (20^2 - 1)/12
  // SciPy: t.ppf(0.975, 19) sqrt(0.35/20) = 0.276879, chi2.ppf([0.975, 0.025], 19) = 32.852327, 8.906516.
  BOOST_TEST(fit.scale.interval.upper == std::exp(1.05 + 0.276879), tolerance(1e-5));
  BOOST_TEST(fit.shape.interval.lower == std::sqrt(19.0 * 0.35 / 32.852327), tolerance(1e-6));
  BOOST_TEST(fit.shape.interval.upper == std::sqrt(19.0 * 0.35 / 8.906516), tolerance(1e-6));
  BOOST_TEST(fit.exceedance(fit.scale.value) == 0.5, tolerance(1e-12));
  BOOST_TEST(fit.goodness.p_value > 0.5);
  // Sizes of two kinds are not log-normal.
  for (int i = 0; i < 20; ++i) sizes.push_back(100.0 + i);
  BOOST_TEST(fit_log_normal_sizes(sizes)->goodness.p_value < 0.001);
}

BOOST_AUTO_TEST_CASE(intervals_of_log_normal_and_weibull_cover_as_often_as_they_say) {
  constexpr int kSamples = 500, kSizes = 60;
  int median = 0, deviation = 0, scale = 0, shape = 0;
  for (std::uint64_t r = 0; r < kSamples; ++r) {
    RandomStream stream(5, "coverage", r, "sizes");
    Samples normal, weibull;
    for (int i = 0; i < kSizes; ++i) {
      normal.push_back(30.0 * std::exp(0.7 * stream.normal()));
      weibull.push_back(20.0 * std::pow(-std::log1p(-stream.uniform()) + 1e-12, 1.0 / 1.6));
    }
    const SizeFit n = fit_log_normal_sizes(normal).value(), w = fit_weibull_sizes(weibull).value();
    median += holds(n.scale.interval, 30.0);
    deviation += holds(n.shape.interval, 0.7);
    scale += holds(w.scale.interval, 20.0);
    shape += holds(w.shape.interval, 1.6);
  }
  check_coverage(median, kSamples, 0.95);
  check_coverage(deviation, kSamples, 0.95);
  // The information matrix is of many sizes: 60 cover a little less.
  check_coverage(scale, kSamples, 0.93);
  check_coverage(shape, kSamples, 0.93);
}

BOOST_AUTO_TEST_CASE(even_quantiles_of_a_power_law_give_it_back) {
  constexpr int kSizes = 400;
  Samples sizes;
  for (int i = 0; i < kSizes; ++i) sizes.push_back(3.0 * std::pow(1.0 - (i + 0.5) / kSizes, -0.5));
  const SizeFit fit = fit_power_tail(sizes, {.n_resamples = 50}).value();
  // The sum of ln(x/3) of the quantiles is n/2 but for half of ln(n)'s order; the least size is the first.
  BOOST_TEST(fit.n == std::size_t{kSizes});
  BOOST_TEST(fit.scale.value == 3.0, tolerance(0.002));
  BOOST_TEST(fit.shape.value == 3.0, tolerance(0.01));
  BOOST_TEST(fit.goodness.p_value > 0.9);
  BOOST_TEST(fit.exceedance(2.0 * fit.scale.value) == std::pow(2.0, 1.0 - fit.shape.value), tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_tail_is_found_where_it_begins_and_its_exponent_is_covered) {
  constexpr int kSamples = 40;
  int exponent = 0, rejected = 0;
  double least = 0.0;
  for (std::uint64_t r = 0; r < kSamples; ++r) {
    const SizeFit fit = fit_power_tail(with_tail(600, 2.5, r), {.n_resamples = 100}).value();
    least += fit.scale.value / kSamples;
    exponent += holds(fit.shape.interval, 2.5);
    rejected += fit.goodness.p_value <= 0.1;
  }
  // The choice of the least size scatters, and rarely lies below the true one (Clauset and others 2009, Fig. 4).
  BOOST_TEST(least > 9.5);
  BOOST_TEST(least < 14.0);
  BOOST_TEST(exponent >= 33);  // 95 % of 40 less 3 deviations
  BOOST_TEST(rejected <= 11);  // 10 % of 40 and 3.5 deviations
}

BOOST_AUTO_TEST_CASE(a_tail_that_ends_is_rejected) {
  RandomStream stream(5, "bounded", 0, "sizes");
  Samples sizes;
  for (int i = 0; i < 3000; ++i) sizes.push_back(1.0 + 9.0 * stream.uniform());
  BOOST_TEST(fit_power_tail(sizes, {.n_resamples = 100})->goodness.p_value <= 0.1);
}

BOOST_AUTO_TEST_CASE(too_few_or_equal_sizes_are_refused) {
  BOOST_TEST(fit_log_normal_sizes(Samples(9, 1.0)).error().reason == "a fit needs at least 10 sizes, and has 9");
  BOOST_TEST(fit_weibull_sizes(Samples(30, 1.0)).error().reason == "all sizes are equal");
  BOOST_TEST(fit_power_tail(Samples(49, 1.0)).error().reason == "a tail needs at least 50 sizes, and has 49");
  BOOST_CHECK_THROW(fit_log_normal_sizes(Samples(20, 0.0)), brash::ContractViolation);
}

}  // namespace
