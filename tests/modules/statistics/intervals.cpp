// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/intervals.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numeric>
#include <vector>

#include "brash/core/contract.hpp"

namespace {

using namespace brash::statistics;
using Samples = std::vector<double>;

Samples first_order(double phi, std::size_t n, std::uint64_t replicate) {
  RandomStream stream(2, "first-order", replicate, "noise");
  Samples x(n);
  x[0] = stream.normal();
  for (std::size_t i = 1; i < n; ++i) x[i] = phi * x[i - 1] + std::sqrt(1.0 - phi * phi) * stream.normal();
  return x;
}

double mean(std::span<const double> x) {
  return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

bool holds(const Interval& interval, double value) { return interval.lower <= value && value <= interval.upper; }

}  // namespace

BOOST_AUTO_TEST_SUITE(intervals)

BOOST_AUTO_TEST_CASE(batch_means_cover_the_mean_of_a_correlated_history) {
  constexpr int kReplicates = 1000;
  int covered = 0;
  for (int r = 0; r < kReplicates; ++r) {
    covered += holds(batch_means_interval(first_order(0.8, 2000, static_cast<std::uint64_t>(r)), 10), 0.0) ? 1 : 0;
  }
  // 1000 trials at 95 %: standard error 0.7 %, three of them; batches of 44 autocorrelation times are almost
  // independent.
  BOOST_TEST(covered > 1000 * (0.95 - 0.021));
  BOOST_TEST(covered < 1000 * (0.95 + 0.021));
}

BOOST_AUTO_TEST_CASE(the_block_bootstrap_covers_the_mean_of_a_correlated_history) {
  constexpr int kBlocks = 400;
  int blocks_covered = 0;
  for (int r = 0; r < kBlocks; ++r) {
    const Samples x = first_order(0.8, 500, static_cast<std::uint64_t>(r));
    RandomStream stream(3, "bootstrap", static_cast<std::uint64_t>(r), "blocks");
    const BootstrapSettings blocks{block_length(4.5, x.size()), 100, 0.95};
    blocks_covered += holds(bootstrap_interval(x, mean, blocks, stream), 0.0) ? 1 : 0;
  }
  BOOST_TEST_MESSAGE("held " << blocks_covered << " of " << kBlocks);
  // Blocks of 25 lose 4.4 / 25 = 18 % of the variance: coverage 92.4 %. The errors of draws make up for the errors
  // that 20 groups leave. Three standard errors of 400 trials are 4 %, the quantiles of 100 resamples cost one more.
  BOOST_TEST(blocks_covered > kBlocks * (0.924 - 0.05));
  BOOST_TEST(blocks_covered < kBlocks * (0.924 + 0.05));
}

BOOST_AUTO_TEST_CASE(the_bootstrap_repeats_with_its_key) {
  const Samples x = first_order(0.5, 200, 0);
  RandomStream first(1, "a", 0, "b"), second(1, "a", 0, "b");
  const Interval a = bootstrap_interval(x, mean, {10, 100, 0.9}, first);
  const Interval b = bootstrap_interval(x, mean, {10, 100, 0.9}, second);
  BOOST_TEST(a.lower == b.lower);
  BOOST_TEST(a.upper == b.upper);
  BOOST_TEST(a.lower < a.upper);
}

BOOST_AUTO_TEST_CASE(the_bootstrap_of_a_mean_is_students_interval_and_a_constant_has_no_width) {
  // The errors of 30 normal values' means follow Student's t, and the bootstrap finds that out.
  int held = 0;
  for (int r = 0; r < 200; ++r) {
    RandomStream stream(5, "students", static_cast<std::uint64_t>(r), "bootstrap");
    Samples x(12);
    for (double& v : x) v = stream.normal();
    held += holds(bootstrap_interval(x, mean, {1, 200, 0.95}, stream), 0.0) ? 1 : 0;
  }
  BOOST_TEST(held > 200 * (0.95 - 0.046));  // three standard errors
  RandomStream stream(1, "a", 0, "b");
  const Interval constant = bootstrap_interval(Samples(8, 3.0), mean, {1, 50, 0.95}, stream);
  BOOST_TEST(constant.lower == 3.0, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(constant.upper == 3.0, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(half_an_interval_takes_the_values_that_students_table_says) {
  // t(0.975, n - 1) / sqrt(n) is 8.985 with 2 values, 2.484 with 3, 1.5912 with 4, 1.2417 with 5, 0.7154 with 10,
  // 0.3605 with 32 and 0.3546 with 33.
  BOOST_TEST(values_for_half_interval(2) == 3u);
  BOOST_TEST(values_for_half_interval(3) == 5u);
  BOOST_TEST(values_for_half_interval(10) == 33u);
  // Many values: the root of their number alone.
  BOOST_TEST(values_for_half_interval(10000) / 10000.0 == 4.0, boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(white_noise_needs_blocks_of_one_sample) {
  BOOST_TEST(block_length(0.5, 100000) == 1U);
  // tau = 4.5: memory 4.5 - 1/18 = 4.444; (1.5 x 19.75 x 1000)^(1/3) = 30.9
  BOOST_TEST(block_length(4.5, 1000) == 31U);
  BOOST_TEST(block_length(1e6, 10) == 10U);
}

BOOST_AUTO_TEST_CASE(intervals_of_too_little_break_the_contract) {
  const Samples x{1.0, 2.0, 3.0};
  RandomStream stream(1, "a", 0, "b");
  BOOST_CHECK_THROW(mean_interval(Samples{1.0}), brash::ContractViolation);
  BOOST_CHECK_THROW(batch_means_interval(x, 4), brash::ContractViolation);
  BOOST_CHECK_THROW(batch_means_interval(x, 1), brash::ContractViolation);
  BOOST_CHECK_THROW(mean_interval(x, 1.0), brash::ContractViolation);
  BOOST_CHECK_THROW(bootstrap_interval(x, mean, {4, 100, 0.9}, stream), brash::ContractViolation);
}

BOOST_AUTO_TEST_SUITE_END()
