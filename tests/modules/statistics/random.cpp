// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/random.hpp"

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "brash/core/contract.hpp"

using brash::statistics::RandomStream;

BOOST_AUTO_TEST_SUITE(random_streams)

BOOST_AUTO_TEST_CASE(the_same_key_gives_the_same_numbers_in_any_order_of_creation) {
  RandomStream first(7, "cone", 3, "wedges", 12);
  RandomStream other(7, "cone", 3, "fields", 12);
  RandomStream again(7, "cone", 3, "wedges", 12);
  for (int i = 0; i < 1000; ++i) {
    other.uniform();
    BOOST_TEST(first.uniform() == again.uniform());
  }
}

BOOST_AUTO_TEST_CASE(the_numbers_of_a_key_never_change) {
  // Recorded: published results depend on them.
  RandomStream stream(1, "cone", 0, "wedges", 0);
  BOOST_TEST(stream.uniform() == 0x1.e71823958da8p-3);
  BOOST_TEST(stream.uniform() == 0x1.172fe61b393p-4);
  BOOST_TEST(stream.normal() == -0.32614317477151744,
             boost::test_tools::tolerance(1e-14));  // libm may differ in the last digits
  BOOST_TEST(stream.uniform_int(3, 5) == 4);
}

BOOST_AUTO_TEST_CASE(the_numbers_of_a_run_never_change) {
  RandomStream stream(1, 0, "wedges", 0);
  BOOST_TEST(stream.uniform() == 0x1.e71823958da8p-3);
}

BOOST_AUTO_TEST_CASE(every_part_of_the_key_counts) {
  const auto first = [](RandomStream stream) { return stream.uniform(); };
  const double reference = first(RandomStream(1, "a", 2, "b", 3));
  BOOST_TEST(first(RandomStream(2, "a", 2, "b", 3)) != reference);
  BOOST_TEST(first(RandomStream(1, "c", 2, "b", 3)) != reference);
  BOOST_TEST(first(RandomStream(1, "a", 3, "b", 3)) != reference);
  BOOST_TEST(first(RandomStream(1, "a", 2, "c", 3)) != reference);
  BOOST_TEST(first(RandomStream(1, "a", 2, "b", 4)) != reference);
  BOOST_TEST(first(RandomStream(1ULL << 40, "a", 2, "b", 3)) != first(RandomStream(1ULL << 41, "a", 2, "b", 3)));
  BOOST_TEST(first(RandomStream(1, "ab", 2, "c", 3)) != first(RandomStream(1, "a", 2, "bc", 3)));
}

BOOST_AUTO_TEST_CASE(many_neighbouring_keys_give_distinct_uniform_and_uncorrelated_streams) {
  // More streams than 31-bit seeds can keep apart: with such seeds about 4.7 pairs of 143 000 would coincide.
  constexpr int kStreams = 143000;
  std::vector<std::pair<double, double>> starts;
  starts.reserve(kStreams);
  std::array<int, 100> bins{};
  double product = 0.0, previous = 0.5;
  for (int i = 0; i < kStreams; ++i) {
    RandomStream stream(1, "cone", static_cast<std::uint64_t>(i % 11), "wedges", static_cast<std::uint64_t>(i / 11));
    const double u = stream.uniform();
    starts.emplace_back(u, stream.uniform());
    ++bins[static_cast<std::size_t>(100.0 * u)];
    product += (u - 0.5) * (previous - 0.5);
    previous = u;
  }
  std::sort(starts.begin(), starts.end());
  BOOST_CHECK(std::adjacent_find(starts.begin(), starts.end()) == starts.end());

  double chi_squared = 0.0;
  const double expected = kStreams / 100.0;
  for (const int count : bins) chi_squared += (count - expected) * (count - expected) / expected;
  // 99 degrees of freedom: the 0.1 % and 99.9 % points of chi squared are 60 and 149.
  BOOST_TEST(chi_squared > 60.0);
  BOOST_TEST(chi_squared < 149.0);
  // Correlation of neighbouring streams, in standard errors: within 3.3 in 99.9 % of cases.
  BOOST_TEST(std::abs(12.0 * product / std::sqrt(double{kStreams})) < 3.3);
}

BOOST_AUTO_TEST_CASE(uniform_numbers_lie_in_the_half_open_unit_interval_with_the_right_moments) {
  RandomStream stream(5, "moments", 0, "uniform");
  constexpr int kN = 200000;
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < kN; ++i) {
    const double u = stream.uniform();
    BOOST_REQUIRE(u >= 0.0 && u < 1.0);
    sum += u - 0.5;
    squares += (u - 0.5) * (u - 0.5);
  }
  // 4 standard errors: deviation of u is sqrt(1/12), of (u - 1/2)^2 is sqrt(1/180).
  BOOST_TEST(std::abs(sum / kN) < 4.0 * std::sqrt(1.0 / 12.0 / kN));
  BOOST_TEST(std::abs(squares / kN - 1.0 / 12.0) < 4.0 * std::sqrt(1.0 / 180.0 / kN));
}

BOOST_AUTO_TEST_CASE(whole_numbers_are_even_between_both_ends) {
  RandomStream stream(5, "whole", 0, "wedges");
  std::array<int, 3> counts{};
  constexpr int kN = 90000;
  for (int i = 0; i < kN; ++i) ++counts.at(static_cast<std::size_t>(stream.uniform_int(3, 5) - 3));
  // 4 standard errors of a count: sqrt(n p (1 - p)) = 141.
  for (const int count : counts) BOOST_TEST(std::abs(count - kN / 3) < 4 * 142);
  BOOST_TEST(stream.uniform_int(-4, -4) == -4);
  BOOST_CHECK_THROW(stream.uniform_int(5, 3), brash::ContractViolation);
}

BOOST_AUTO_TEST_CASE(normal_numbers_have_mean_0_deviation_1_and_no_excess) {
  RandomStream stream(5, "moments", 0, "normal");
  constexpr int kN = 200000;
  double m1 = 0.0, m2 = 0.0, m4 = 0.0;
  for (int i = 0; i < kN; ++i) {
    const double x = stream.normal();
    m1 += x;
    m2 += x * x;
    m4 += x * x * x * x;
  }
  // 4 standard errors: variances of x, x^2, x^4 are 1, 2, 96.
  BOOST_TEST(std::abs(m1 / kN) < 4.0 * std::sqrt(1.0 / kN));
  BOOST_TEST(std::abs(m2 / kN - 1.0) < 4.0 * std::sqrt(2.0 / kN));
  BOOST_TEST(std::abs(m4 / kN - 3.0) < 4.0 * std::sqrt(96.0 / kN));
}

BOOST_AUTO_TEST_SUITE_END()
