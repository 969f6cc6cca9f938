// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "brash/statistics/summary.hpp"

namespace brash::statistics {

/// Outcome of a test: the statistic named by the function and the probability of a more extreme one by chance.
struct TestResult {
  double statistic = 0.0;
  double p_value = 1.0;
};

/// Kendall's tau-b of pairs (x_i, y_i); two-sided. Exact for up to 33 pairs without ties, normal with the variance for
/// ties otherwise; p = 1 when one side is constant.
///
/// @param x, y  shape=(n,) each, n >= 2.
TestResult kendall(std::span<const double> x, std::span<const double> y);

/// Jonckheere and Terpstra's test whether groups of values rise in the given order, e.g. mean loads of replicates at
/// rising cone angles. Statistic: the standardised J (positive when rising); two-sided p: exact without ties for up to
/// 5000 pairs of values of different groups, else normal with the variance for ties.
///
/// @param groups  at least two, not empty, in the order that is tested.
TestResult jonckheere_terpstra(const std::vector<std::vector<double>>& groups);

/// The same within strata, such as the speeds of a grid of angles and speeds: the scores of the strata add, and their
/// variances. Exact without ties for up to 5000 pairs in all strata together, else normal.
TestResult jonckheere_terpstra(const std::vector<std::vector<std::vector<double>>>& strata);

/// Kendall's tau-b between group and value over strata: their scores added, over the largest that their ties allow.
/// Each value is compared within its stratum alone; 0 where nothing can be compared.
double kendall_tau(const std::vector<std::vector<std::vector<double>>>& strata);

/// Holm's adjustment of p-values for testing several hypotheses; a result below alpha keeps the chance of any false
/// rejection below alpha. Order kept.
std::vector<double> holm(std::span<const double> p_values);

/// Difference of two means with its interval, and Welch's t test that it is zero.
struct MeanComparison {
  double difference = 0.0;  ///< mean of a less mean of b
  Interval interval;        ///< at the stated confidence
  TestResult test;          ///< t, two-sided
};

/// Independent values, such as the means of replicates; at least 2 in each.
MeanComparison compare_means(std::span<const double> a, std::span<const double> b, double confidence = 0.95);

/// A stratum of two groups of independent values.
struct PairOfGroups {
  std::vector<double> a, b;  ///< at least 2 in each
};

/// Mean over the strata of the difference of two means; each stratum counts the same.
MeanComparison compare_means(const std::vector<PairOfGroups>& strata, double confidence = 0.95);

/// Two correlated histories: their effective sample sizes take the place of the counts.
MeanComparison compare_means(const Summary& a, const Summary& b, double confidence = 0.95);

/// Mean of one correlated history against zero, such as of the differences of two paired histories.
MeanComparison compare_with_zero(const Summary& differences, double confidence = 0.95);

/// Ratio of two positive quantities with its interval, and the test that it is one.
struct RatioComparison {
  double ratio = 1.0;  ///< of a over b
  Interval interval;   ///< at the stated confidence
  TestResult test;     ///< t of the logarithm, two-sided
};

/// Ratio of the means of two correlated histories, both positive. Its logarithm is taken as Student's with the relative
/// errors of both, Welch's degrees of freedom and the effective sample sizes in place of the counts.
RatioComparison compare_ratio(const Summary& a, const Summary& b, double confidence = 0.95);

/// Ratio of the deviations of two correlated histories: the root of the ratio of the mean squared deviations, whose
/// errors follow from their own effective sample sizes.
///
/// @param squares_a, squares_b  summaries of the squared deviations from the mean; their means are positive.
RatioComparison compare_deviations(const Summary& squares_a, const Summary& squares_b, double confidence = 0.95);

/// Kolmogorov and Smirnov's test that two independent samples have one distribution. Statistic: the largest distance
/// of the two shares; exact p without ties, too large with them.
///
/// @param a, b  not empty; time grows as the product of the counts. Samples of a history are nearly independent when
///              they are four autocorrelation times apart.
TestResult kolmogorov_smirnov(std::span<const double> a, std::span<const double> b);

/// Mann and Whitney's test that neither sample tends to larger values; statistic U of `a`; two-sided, normal with
/// correction for ties and continuity.
TestResult mann_whitney(std::span<const double> a, std::span<const double> b);

}  // namespace brash::statistics
