// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/hypothesis.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "brash/core/contract.hpp"
#include "brash/statistics/random.hpp"

namespace {

using namespace brash::statistics;
using Samples = std::vector<double>;
using boost::test_tools::tolerance;

/// Two-sided Kendall p by trying every permutation of y; x is 0, 1, 2, ...
double kendall_by_permutations(Samples y) {
  const auto score = [](const Samples& v) {
    int s = 0;
    for (std::size_t i = 0; i < v.size(); ++i)
      for (std::size_t j = i + 1; j < v.size(); ++j) s += v[j] > v[i] ? 1 : -1;
    return s;
  };
  const int observed = std::abs(score(y));
  int n = 0, as_far = 0;
  std::sort(y.begin(), y.end());
  do {
    ++n;
    as_far += std::abs(score(y)) >= observed ? 1 : 0;
  } while (std::next_permutation(y.begin(), y.end()));
  return static_cast<double>(as_far) / n;
}

/// Two-sided p of Jonckheere and Terpstra by trying every order of the values.
double jonckheere_by_permutations(const std::vector<Samples>& groups) {
  std::vector<std::size_t> group;
  Samples values;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    group.insert(group.end(), groups[g].size(), g);
    values.insert(values.end(), groups[g].begin(), groups[g].end());
  }
  const auto score = [&](const Samples& v) {
    int s = 0;
    for (std::size_t i = 0; i < v.size(); ++i)
      for (std::size_t j = i + 1; j < v.size(); ++j)
        if (group[i] != group[j]) s += v[j] > v[i] ? 1 : -1;
    return s;
  };
  const int observed = std::abs(score(values));
  int n = 0, as_far = 0;
  std::sort(values.begin(), values.end());
  do {
    ++n;
    as_far += std::abs(score(values)) >= observed ? 1 : 0;
  } while (std::next_permutation(values.begin(), values.end()));
  return static_cast<double>(as_far) / n;
}

/// A first-order process of deviation 1 with a correlation of 0.8 between neighbours.
Samples correlated(std::uint64_t replicate, std::size_t n) {
  RandomStream stream(6, "hypothesis", replicate, "correlated");
  Samples x{stream.normal()};
  while (x.size() < n) x.push_back(0.8 * x.back() + 0.6 * stream.normal());
  return x;
}

Summary of_squares(Samples x) {
  for (double& value : x) value *= value;
  return summarise(x, 1.0);
}

Samples normals(const char* purpose, std::uint64_t replicate, int n, double shift = 0.0) {
  RandomStream stream(6, "hypothesis", replicate, purpose);
  Samples x;
  for (int i = 0; i < n; ++i) x.push_back(shift + stream.normal());
  return x;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(hypothesis)

BOOST_AUTO_TEST_CASE(exact_kendall_counts_permutations) {
  for (const Samples& y : {Samples{1, 2, 3, 4, 5}, Samples{2, 1, 4, 3, 5}, Samples{3, 1, 4, 2, 6, 5, 7}}) {
    Samples x(y.size());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = static_cast<double>(i);
    BOOST_TEST(kendall(x, y).p_value == kendall_by_permutations(y), tolerance(1e-13));  // rounding of a few sums
  }
}

BOOST_AUTO_TEST_CASE(a_rising_series_has_tau_one_and_a_constant_one_says_nothing) {
  const Samples x{1, 2, 3, 4, 5};
  BOOST_TEST(kendall(x, x).statistic == 1.0);
  BOOST_TEST(kendall(x, x).p_value == 2.0 / 120.0, tolerance(1e-14));
  BOOST_TEST(kendall(x, Samples(5, 3.0)).p_value == 1.0);
}

BOOST_AUTO_TEST_CASE(jonckheere_terpstra_rejects_true_equality_in_5_of_100_cases_and_finds_a_trend) {
  int rejected = 0, found = 0;
  constexpr int kTrials = 1000;
  for (std::uint64_t r = 0; r < kTrials; ++r) {
    std::vector<Samples> equal, rising;
    for (int g = 0; g < 5; ++g) {
      equal.push_back(normals("equal", 10 * r + static_cast<std::uint64_t>(g), 6));
      rising.push_back(normals("rising", 10 * r + static_cast<std::uint64_t>(g), 6, 0.5 * g));
    }
    rejected += jonckheere_terpstra(equal).p_value < 0.05 ? 1 : 0;
    const TestResult trend = jonckheere_terpstra(rising);
    found += trend.p_value < 0.05 && trend.statistic > 0.0 ? 1 : 0;
  }
  BOOST_TEST(std::abs(rejected - 0.05 * kTrials) < 3.0 * 6.9);  // three errors of a count, sqrt(1000 x 0.05 x 0.95)
  BOOST_TEST(found > 0.95 * kTrials);                           // ends differ by 2 deviations
}

BOOST_AUTO_TEST_CASE(exact_jonckheere_terpstra_counts_permutations) {
  for (const std::vector<Samples>& groups :
       {std::vector<Samples>{{1, 4}, {2, 3, 7}, {5, 6, 8}}, std::vector<Samples>{{1, 2, 3}, {4}, {5, 6}, {7}},
        std::vector<Samples>{{6, 3, 1}, {2, 5, 4, 7}}}) {
    BOOST_TEST(jonckheere_terpstra(groups).p_value == jonckheere_by_permutations(groups),
               tolerance(1e-12));  // rounding of sums
  }
}

BOOST_AUTO_TEST_CASE(equal_deviations_of_correlated_histories_are_rejected_in_5_of_100_cases) {
  int rejected = 0;
  constexpr int kTrials = 400;
  for (std::uint64_t r = 0; r < kTrials; ++r) {
    const RatioComparison c =
        compare_deviations(of_squares(correlated(2 * r, 4000)), of_squares(correlated(2 * r + 1, 2000)));
    rejected += c.test.p_value < 0.05 ? 1 : 0;
    BOOST_TEST((c.interval.lower <= 1.0 && 1.0 <= c.interval.upper) == (c.test.p_value >= 0.05));
  }
  // Three errors of a count, sqrt(400 x 0.05 x 0.95), and as much again for tau being estimated from the same samples.
  BOOST_TEST(std::abs(rejected - 0.05 * kTrials) < 6.0 * 4.4);
}

BOOST_AUTO_TEST_CASE(a_ratio_of_deviations_scales_with_the_values) {
  Samples larger = correlated(1, 3000);
  const Summary squares = of_squares(larger);
  for (double& value : larger) value *= 3.0;
  const RatioComparison c = compare_deviations(of_squares(larger), squares);
  BOOST_TEST(c.ratio == 3.0, tolerance(1e-12));
  BOOST_TEST(c.interval.lower > 1.0);
  BOOST_TEST(compare_ratio(squares, squares).test.p_value == 1.0);
}

BOOST_AUTO_TEST_CASE(equal_samples_have_no_distance_and_disjoint_ones_the_least_probability) {
  const Samples a{1, 2, 3, 4, 5}, b{6, 7, 8, 9, 10};
  BOOST_TEST(kolmogorov_smirnov(a, a).statistic == 0.0);
  BOOST_TEST(kolmogorov_smirnov(a, a).p_value == 1.0);
  BOOST_TEST(kolmogorov_smirnov(a, b).statistic == 1.0);
  BOOST_TEST(kolmogorov_smirnov(a, b).p_value == 2.0 / 252.0, tolerance(1e-12));  // of 10 choose 5 orders
}

BOOST_AUTO_TEST_CASE(jonckheere_terpstra_over_strata_is_exact_for_few_pairs_without_ties) {
  using Strata = std::vector<std::vector<Samples>>;
  // All values rise in both strata: one of 6 orders each, and as many fall.
  const TestResult rising = jonckheere_terpstra(Strata{{{1, 2}, {3, 4}}, {{10, 20}, {30, 40}}});
  BOOST_TEST(rising.p_value == 2.0 / 36.0, tolerance(1e-14));
  // Mann and Whitney's U of 2 and 1 values is 0, 1 or 2 with equal chance, of 1 and 1 it is 0 or 1. The sum has the
  // chances 1, 2, 2, 1 of 6. Here it is 2: the sums 0 to 3 are all as far from 1.5 as 1 and 2 are.
  BOOST_TEST(jonckheere_terpstra(Strata{{{1, 3}, {2}}, {{5}, {6}}}).p_value == 1.0, tolerance(1e-14));
  BOOST_TEST(jonckheere_terpstra(Strata{{{1, 2}, {3}}, {{5}, {6}}}).p_value == 2.0 / 6.0, tolerance(1e-14));
  // Strata that rise and fall alike cancel, and a tie leaves the normal law.
  BOOST_TEST(jonckheere_terpstra(Strata{{{1, 2}, {3, 4}}, {{3, 4}, {1, 2}}}).p_value == 1.0, tolerance(1e-14));
  BOOST_TEST(jonckheere_terpstra(Strata{{{1, 2}, {3, 4}}, {{1, 2}, {2, 4}}}).p_value < 0.05);
}

BOOST_AUTO_TEST_CASE(jonckheere_terpstra_needs_the_order_of_the_groups) {
  std::vector<Samples> groups{{1, 2}, {3, 4}, {5, 6}};
  const double rising = jonckheere_terpstra(groups).statistic;
  std::reverse(groups.begin(), groups.end());
  BOOST_TEST(jonckheere_terpstra(groups).statistic == -rising);
  BOOST_TEST(jonckheere_terpstra({{1, 1}, {1, 1}}).p_value == 1.0);
  BOOST_CHECK_THROW(jonckheere_terpstra({{1, 2}}), brash::ContractViolation);
  BOOST_CHECK_THROW(jonckheere_terpstra({{1, 2}, {}}), brash::ContractViolation);
}

BOOST_AUTO_TEST_CASE(holm_steps_down_and_never_reorders) {
  // Sorted 0.01, 0.02, 0.03, 0.04 times 4, 3, 2, 1: 0.04, 0.06, then never less than before.
  const Samples adjusted = holm(Samples{0.04, 0.01, 0.03, 0.02});
  BOOST_TEST(adjusted == (Samples{0.06, 0.04, 0.06, 0.06}), tolerance(1e-15) << boost::test_tools::per_element());
  BOOST_TEST(holm(Samples{0.6, 0.7}) == (Samples{1.0, 1.0}), boost::test_tools::per_element());
  BOOST_TEST(holm(Samples{}).empty());
  BOOST_CHECK_THROW(holm(Samples{1.5}), brash::ContractViolation);
}

BOOST_AUTO_TEST_CASE(holm_keeps_the_chance_of_any_false_alarm_at_5_of_100) {
  int alarms = 0;
  for (std::uint64_t r = 0; r < 1000; ++r) {
    Samples p;
    for (std::uint64_t k = 0; k < 6; ++k)
      p.push_back(compare_means(normals("a", 6 * r + k, 8), normals("b", 6 * r + k, 8)).test.p_value);
    const Samples adjusted = holm(p);
    alarms += *std::min_element(adjusted.begin(), adjusted.end()) < 0.05 ? 1 : 0;
  }
  BOOST_TEST(alarms < 1000 * 0.05 + 3.0 * 6.9);
}

BOOST_AUTO_TEST_CASE(correlated_histories_are_compared_by_their_effective_sample_sizes) {
  Summary a, b;
  a.mean = 10.0, b.mean = 9.0;
  a.standard_deviation = b.standard_deviation = 2.0;
  a.effective_sample_size = b.effective_sample_size = 32.0;
  const MeanComparison c = compare_means(a, b);
  BOOST_TEST(c.test.statistic == 2.0, tolerance(1e-14));              // 1 / sqrt(2 x 4 / 32)
  BOOST_CHECK_SMALL(c.interval.lower - (1.0 - 0.5 * 1.99897), 5e-6);  // t(62), 97.5 %, from a table
}

BOOST_AUTO_TEST_CASE(samples_without_spread_are_equal_or_different) {
  BOOST_TEST(compare_means(Samples{1, 1}, Samples{1, 1}).test.p_value == 1.0);
  BOOST_TEST(compare_means(Samples{1, 1}, Samples{2, 2}).test.p_value == 0.0);
  BOOST_TEST(mann_whitney(Samples{1, 1}, Samples{1, 1}).p_value == 1.0);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_CASE(kendall_s_tau_over_strata_is_one_stratum_s_where_all_rise_as_far_as_they_can) {
  // Two groups of two: 4 of 6 pairs can rise, tau-b 4/sqrt(4 6). Shifts between strata change nothing.
  using Strata = std::vector<std::vector<Samples>>;
  const Strata rising{{{1, 2}, {3, 4}}, {{30, 40}, {50, 60}}};
  BOOST_TEST(kendall_tau(Strata{rising.front()}) == 4.0 / std::sqrt(24.0), tolerance(1e-14));
  BOOST_TEST(kendall_tau(rising) == 4.0 / std::sqrt(24.0), tolerance(1e-14));
  // The second falls as far as the first rises.
  BOOST_TEST(kendall_tau(Strata{rising.front(), {{3, 4}, {1, 2}}}) == 0.0);
  BOOST_TEST(kendall_tau(Strata{{{1}, {1}}}) == 0.0);
}
