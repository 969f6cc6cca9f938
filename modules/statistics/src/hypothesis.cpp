// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/hypothesis.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "brash/core/contract.hpp"
#include "brash/core/interruption.hpp"
#include "gsl_checked.hpp"
#include "samples.hpp"

namespace brash::statistics {
namespace {

constexpr std::size_t kExactKendall = 33;    // pairs; beyond, the normal approximation is good to three digits
constexpr double kExactJonckheere = 5000.0;  // pairs of different groups of all strata, as above; five groups of 22

double two_sided_normal(double z) { return std::min(1.0, 2.0 * gsl_cdf_ugaussian_Q(std::abs(z))); }

/// Sums over the groups of equal values with t members each.
struct Ties {
  double pairs = 0.0;     ///< sum t (t - 1)
  double triples = 0.0;   ///< sum t (t - 1)(t - 2)
  double weighted = 0.0;  ///< sum t (t - 1)(2 t + 5)
};

Ties ties(std::span<const double> values) {
  std::vector<double> sorted(values.begin(), values.end());
  std::ranges::sort(sorted);
  Ties result;
  for (auto first = sorted.begin(); first != sorted.end();) {
    const auto last = std::upper_bound(first, sorted.end(), *first);
    const auto t = static_cast<double>(last - first);
    result.pairs += t * (t - 1.0);
    result.triples += t * (t - 1.0) * (t - 2.0);
    result.weighted += t * (t - 1.0) * (2.0 * t + 5.0);
    first = last;
  }
  return result;
}

/// Kendall's S, concordant less discordant pairs, with the quantities that its distribution needs.
struct Concordance {
  double n = 0.0;
  double score = 0.0;
  Ties x, y;

  /// Of S under no association, with ties on both sides.
  double variance() const {
    double v = (n * (n - 1.0) * (2.0 * n + 5.0) - x.weighted - y.weighted) / 18.0;
    v += x.pairs * y.pairs / (2.0 * n * (n - 1.0));
    if (n > 2.0) v += x.triples * y.triples / (9.0 * n * (n - 1.0) * (n - 2.0));
    return v;
  }
};

/// How many ranks were added so far, up to each: a Fenwick tree.
class RankCounts {
 public:
  explicit RankCounts(std::size_t n_ranks) : sums_(n_ranks + 1, 0) {}
  void add(std::size_t rank) {
    for (std::size_t i = rank + 1; i < sums_.size(); i += i & (~i + 1)) ++sums_[i];
  }
  /// Of ranks below `rank`.
  std::int64_t below(std::size_t rank) const {
    std::int64_t sum = 0;
    for (std::size_t i = rank; i > 0; i &= i - 1) sum += sums_[i];
    return sum;
  }

 private:
  std::vector<std::int64_t> sums_;
};

/// The place of each value among the different values, from 0 on.
std::vector<std::size_t> ranks(std::span<const double> values) {
  std::vector<double> sorted(values.begin(), values.end());
  std::ranges::sort(sorted);
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  std::vector<std::size_t> result;
  for (const double value : values)
    result.push_back(static_cast<std::size_t>(std::ranges::lower_bound(sorted, value) - sorted.begin()));
  return result;
}

/// Each value is compared with all of a smaller x at once, so that long samples take n log n.
Concordance concordance(std::span<const double> x, std::span<const double> y) {
  BRASH_EXPECTS(x.size() == y.size() && x.size() >= 2, x.size(), y.size());
  BRASH_EXPECTS(all_finite(x) && all_finite(y));
  const std::vector<std::size_t> rank = ranks(y);
  std::vector<std::size_t> by_x(x.size());
  std::iota(by_x.begin(), by_x.end(), std::size_t{0});
  std::ranges::stable_sort(by_x, {}, [&](std::size_t i) { return x[i]; });
  RankCounts counts(x.size());
  std::int64_t score = 0;
  for (std::size_t first = 0, last = 0; first < by_x.size(); first = last) {
    look_for_interruption();
    for (; last < by_x.size() && x[by_x[last]] == x[by_x[first]]; ++last) {
      const std::size_t r = rank[by_x[last]];
      score += counts.below(r) - (static_cast<std::int64_t>(first) - counts.below(r + 1));
    }
    for (std::size_t i = first; i < last; ++i) counts.add(rank[by_x[i]]);
  }
  return {static_cast<double>(x.size()), static_cast<double>(score), ties(x), ties(y)};
}

/// Two-sided probability of a Kendall score at least as far from zero, by counting permutations; no ties.
double exact_kendall(std::size_t n, double score) {
  const std::size_t pairs = n * (n - 1) / 2;
  const auto inversions = static_cast<std::size_t>(0.5 * (static_cast<double>(pairs) - std::abs(score)));
  // share[k]: probability of k inversions among permutations of m things; the m-th adds 0 to m - 1 with equal chance.
  std::vector<double> share(inversions + 1, 0.0);
  share[0] = 1.0;
  for (std::size_t m = 2; m <= n; ++m) {
    look_for_interruption();
    std::vector<double> next(inversions + 1, 0.0);
    for (std::size_t k = 0; k <= inversions; ++k)
      for (std::size_t added = 0; added < m && added <= k; ++added)
        next[k] += share[k - added] / static_cast<double>(m);
    share = std::move(next);
  }
  return std::min(1.0, 2.0 * std::accumulate(share.begin(), share.end(), 0.0));
}

using Shares = std::vector<double>;

/// Probabilities of Mann and Whitney's U = 0, 1, ..., m n for samples of m and n values without ties.
Shares mann_whitney_shares(std::size_t m, std::size_t n) {
  // The largest of all values is one of the m with the chance m/(m + n) and then exceeds the n others.
  std::vector<Shares> of(n + 1, Shares{1.0});
  for (std::size_t i = 1; i <= m; ++i) {
    for (std::size_t j = 1; j <= n; ++j) {
      look_for_interruption();
      const double first = static_cast<double>(i) / static_cast<double>(i + j);
      Shares next(i * j + 1, 0.0);
      for (std::size_t u = 0; u < of[j].size(); ++u) next[u + j] += first * of[j][u];
      for (std::size_t u = 0; u < of[j - 1].size(); ++u) next[u] += (1.0 - first) * of[j - 1][u];
      of[j] = std::move(next);
    }
  }
  return of[n];
}

/// Probabilities of the sum of two independent whole numbers from 0 on.
Shares shares_of_sum(const Shares& a, const Shares& b) {
  Shares sum(a.size() + b.size() - 1, 0.0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    look_for_interruption();
    for (std::size_t k = 0; k < b.size(); ++k) sum[i + k] += a[i] * b[k];
  }
  return sum;
}

/// Probabilities of Jonckheere and Terpstra's J = 0, 1, ...; no ties. J is the sum of the U of each group against all
/// before it, which are independent.
Shares jonckheere_shares(const std::vector<std::vector<double>>& groups) {
  Shares of_j{1.0};
  std::size_t before = groups.front().size();
  for (std::size_t g = 1; g < groups.size(); ++g) {
    of_j = shares_of_sum(of_j, mann_whitney_shares(groups[g].size(), before));
    before += groups[g].size();
  }
  return of_j;
}

/// Two-sided probability of a sum of J over strata at least as far out; no ties.
double exact_jonckheere(const std::vector<std::vector<std::vector<double>>>& strata, double score) {
  Shares of_j{1.0};
  for (const auto& groups : strata) of_j = shares_of_sum(of_j, jonckheere_shares(groups));
  // The distribution is symmetric about half of the pairs; |S| = |2 J - pairs|.
  const auto least = static_cast<std::size_t>(0.5 * (static_cast<double>(of_j.size() - 1) - std::abs(score)));
  const auto end = of_j.begin() + static_cast<std::ptrdiff_t>(least) + 1;
  return std::min(1.0, 2.0 * std::accumulate(of_j.begin(), end, 0.0));
}

/// J is Kendall's S between a value's group and the value: S = 2 J - (pairs of different groups).
Concordance rise(const std::vector<std::vector<double>>& groups) {
  BRASH_EXPECTS(groups.size() >= 2, groups.size());
  std::vector<double> order, values;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    BRASH_EXPECTS(!groups[g].empty(), g);
    order.insert(order.end(), groups[g].size(), static_cast<double>(g));
    values.insert(values.end(), groups[g].begin(), groups[g].end());
  }
  return concordance(order, values);
}

double freedom_of(const Summary& s) { return std::max(1.0, s.effective_sample_size - 1.0); }

/// The variance of a mean and its degrees of freedom.
struct ErrorOfMean {
  double variance = 0.0, freedom = 1.0;
};

/// A difference of means from the errors of its parts, after Welch and Satterthwaite.
MeanComparison compare(double difference, std::span<const ErrorOfMean> parts, double confidence) {
  BRASH_EXPECTS(confidence > 0.0 && confidence < 1.0, confidence);
  quiet_gsl();
  double variance = 0.0, weighted = 0.0;
  for (const ErrorOfMean& part : parts) {
    variance += part.variance;
    weighted += part.variance * part.variance / part.freedom;
  }
  MeanComparison result;
  result.difference = difference;
  result.interval = {difference, difference};
  result.test.p_value = difference == 0.0 ? 1.0 : 0.0;
  if (variance == 0.0) return result;
  const double freedom = variance * variance / weighted;
  const double half_width = gsl_cdf_tdist_Pinv(0.5 + 0.5 * confidence, freedom) * std::sqrt(variance);
  result.interval = {difference - half_width, difference + half_width};
  result.test.statistic = difference / std::sqrt(variance);
  result.test.p_value = std::min(1.0, 2.0 * gsl_cdf_tdist_Q(std::abs(result.test.statistic), freedom));
  return result;
}

/// Of independent values.
ErrorOfMean error_of_mean(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  return {gsl_stats_variance(values.data(), 1, values.size()) / n, n - 1.0};
}

/// Of a correlated history.
ErrorOfMean error_of_mean(const Summary& s) {
  return {s.standard_deviation * s.standard_deviation / s.effective_sample_size, freedom_of(s)};
}

}  // namespace

TestResult kendall(std::span<const double> x, std::span<const double> y) {
  quiet_gsl();
  const Concordance c = concordance(x, y);
  const double pairs = c.n * (c.n - 1.0);
  if (c.x.pairs == pairs || c.y.pairs == pairs) return {0.0, 1.0};
  TestResult result;
  result.statistic = 2.0 * c.score / std::sqrt((pairs - c.x.pairs) * (pairs - c.y.pairs));
  const bool tied = c.x.pairs > 0.0 || c.y.pairs > 0.0;
  result.p_value = !tied && x.size() <= kExactKendall ? exact_kendall(x.size(), c.score)
                                                      : two_sided_normal(c.score / std::sqrt(c.variance()));
  return result;
}

TestResult jonckheere_terpstra(const std::vector<std::vector<double>>& groups) {
  return jonckheere_terpstra(std::vector<std::vector<std::vector<double>>>{groups});
}

TestResult jonckheere_terpstra(const std::vector<std::vector<std::vector<double>>>& strata) {
  BRASH_EXPECTS(!strata.empty());
  quiet_gsl();
  double score = 0.0, variance = 0.0, pairs = 0.0;
  bool tied = false;
  for (const auto& groups : strata) {
    const Concordance c = rise(groups);
    pairs += 0.5 * (c.n * (c.n - 1.0) - c.x.pairs);
    tied = tied || c.y.pairs > 0.0;
    if (!(c.variance() > 0.0) || c.y.pairs == c.n * (c.n - 1.0)) continue;
    score += c.score;
    variance += c.variance();
  }
  if (!(variance > 0.0)) return {0.0, 1.0};
  const double z = score / std::sqrt(variance);
  return {z, !tied && pairs <= kExactJonckheere ? exact_jonckheere(strata, score) : two_sided_normal(z)};
}

double kendall_tau(const std::vector<std::vector<std::vector<double>>>& strata) {
  double score = 0.0, largest = 0.0;
  for (const auto& groups : strata) {
    const Concordance c = rise(groups);
    const double pairs = c.n * (c.n - 1.0);
    score += c.score;
    largest += 0.5 * std::sqrt((pairs - c.x.pairs) * (pairs - c.y.pairs));
  }
  return largest > 0.0 ? score / largest : 0.0;
}

std::vector<double> holm(std::span<const double> p_values) {
  for (const double p : p_values) BRASH_EXPECTS(p >= 0.0 && p <= 1.0, p);
  std::vector<std::size_t> order(p_values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return p_values[i]; });
  std::vector<double> adjusted(p_values.size());
  double running = 0.0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    const auto left = static_cast<double>(order.size() - rank);
    running = std::max(running, std::min(1.0, left * p_values[order[rank]]));
    adjusted[order[rank]] = running;
  }
  return adjusted;
}

MeanComparison compare_means(std::span<const double> a, std::span<const double> b, double confidence) {
  BRASH_EXPECTS(a.size() >= 2 && b.size() >= 2, a.size(), b.size());
  BRASH_EXPECTS(all_finite(a) && all_finite(b));
  const double difference = gsl_stats_mean(a.data(), 1, a.size()) - gsl_stats_mean(b.data(), 1, b.size());
  return compare(difference, std::array{error_of_mean(a), error_of_mean(b)}, confidence);
}

MeanComparison compare_means(const std::vector<PairOfGroups>& strata, double confidence) {
  BRASH_EXPECTS(!strata.empty());
  const auto n = static_cast<double>(strata.size());
  double difference = 0.0;
  std::vector<ErrorOfMean> parts;
  for (const auto& [a, b] : strata) {
    difference += compare_means(a, b, confidence).difference / n;
    for (const auto* group : {&a, &b}) {
      parts.push_back(error_of_mean(*group));
      parts.back().variance /= n * n;
    }
  }
  return compare(difference, parts, confidence);
}

MeanComparison compare_means(const Summary& a, const Summary& b, double confidence) {
  return compare(a.mean - b.mean, std::array{error_of_mean(a), error_of_mean(b)}, confidence);
}

MeanComparison compare_with_zero(const Summary& differences, double confidence) {
  return compare(differences.mean, std::array{error_of_mean(differences)}, confidence);
}

RatioComparison compare_ratio(const Summary& a, const Summary& b, double confidence) {
  BRASH_EXPECTS(a.mean > 0.0 && b.mean > 0.0, a.mean, b.mean);
  const auto variance = [](const Summary& s) {
    const double relative = s.standard_deviation / s.mean;
    return relative * relative / s.effective_sample_size;
  };
  const MeanComparison logarithm =
      compare(std::log(a.mean / b.mean),
              std::array{ErrorOfMean{variance(a), freedom_of(a)}, ErrorOfMean{variance(b), freedom_of(b)}}, confidence);
  return {std::exp(logarithm.difference),
          {std::exp(logarithm.interval.lower), std::exp(logarithm.interval.upper)},
          logarithm.test};
}

RatioComparison compare_deviations(const Summary& squares_a, const Summary& squares_b, double confidence) {
  RatioComparison result = compare_ratio(squares_a, squares_b, confidence);
  result.ratio = std::sqrt(result.ratio);
  result.interval = {std::sqrt(result.interval.lower), std::sqrt(result.interval.upper)};
  return result;
}

TestResult kolmogorov_smirnov(std::span<const double> a, std::span<const double> b) {
  BRASH_EXPECTS(!a.empty() && !b.empty(), a.size(), b.size());
  BRASH_EXPECTS(all_finite(a) && all_finite(b));
  std::vector<double> x(a.begin(), a.end()), y(b.begin(), b.end());
  std::ranges::sort(x);
  std::ranges::sort(y);
  // Distance of the shares i/m and j/n as the whole number |i n - j m|.
  const auto m = static_cast<std::int64_t>(x.size()), n = static_cast<std::int64_t>(y.size());
  std::int64_t i = 0, j = 0, largest = 0;
  while (i < m && j < n) {
    const double value = std::min(x[static_cast<std::size_t>(i)], y[static_cast<std::size_t>(j)]);
    while (i < m && x[static_cast<std::size_t>(i)] == value) ++i;
    while (j < n && y[static_cast<std::size_t>(j)] == value) ++j;
    largest = std::max(largest, std::abs(i * n - j * m));
  }
  if (largest == 0) return {0.0, 1.0};
  // Chance that a random order of m and n values never comes that far: over the band of the lattice of (i, j) that is
  // nearer to the diagonal. Left of the band there is none.
  std::vector<double> inside(static_cast<std::size_t>(n) + 1, 0.0);
  inside[0] = 1.0;
  for (std::int64_t row = 0; row <= m; ++row) {
    look_for_interruption();
    const std::int64_t first = row * n < largest ? 0 : (row * n - largest) / m + 1;
    const std::int64_t last = std::min(n, (row * n + largest - 1) / m);
    if (first > 0) inside[static_cast<std::size_t>(first) - 1] = 0.0;
    for (std::int64_t column = first; column <= last; ++column) {
      if (row + column == 0) continue;
      const auto k = static_cast<std::size_t>(column);
      const double steps = static_cast<double>(row + column);
      inside[k] *= static_cast<double>(row) / steps;
      if (column > 0) inside[k] += inside[k - 1] * static_cast<double>(column) / steps;
    }
  }
  return {static_cast<double>(largest) / static_cast<double>(m * n), std::clamp(1.0 - inside.back(), 0.0, 1.0)};
}

TestResult mann_whitney(std::span<const double> a, std::span<const double> b) {
  BRASH_EXPECTS(!a.empty() && !b.empty(), a.size(), b.size());
  BRASH_EXPECTS(all_finite(a) && all_finite(b));
  quiet_gsl();
  std::vector<double> sorted(b.begin(), b.end());
  std::ranges::sort(sorted);
  double u = 0.0;
  for (const double x : a) {
    look_for_interruption();
    const auto [first, last] = std::equal_range(sorted.begin(), sorted.end(), x);
    u += static_cast<double>(first - sorted.begin()) + 0.5 * static_cast<double>(last - first);
  }
  std::vector<double> all(a.begin(), a.end());
  all.insert(all.end(), b.begin(), b.end());
  const auto n_a = static_cast<double>(a.size()), n_b = static_cast<double>(b.size()), n = n_a + n_b;
  const Ties t = ties(all);
  // sum (t^3 - t) = sum t (t-1)(t-2) + 3 sum t (t-1)
  const double variance = n_a * n_b / 12.0 * (n + 1.0 - (t.triples + 3.0 * t.pairs) / (n * (n - 1.0)));
  if (!(variance > 0.0)) return {u, 1.0};
  const double distance = std::max(0.0, std::abs(u - 0.5 * n_a * n_b) - 0.5);
  return {u, two_sided_normal(distance / std::sqrt(variance))};
}

}  // namespace brash::statistics
