// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/moments.hpp"

#include <gsl/gsl_histogram.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "gsl_checked.hpp"
#include "samples.hpp"

namespace brash::statistics {

Moments moments(std::span<const double> samples) { return moments(samples, std::array{1.0}); }

Moments moments(std::span<const double> samples, std::span<const double> weights) {
  BRASH_EXPECTS(samples.size() >= 2 && (weights.size() == samples.size() || weights.size() == 1), samples.size(),
                weights.size());
  BRASH_EXPECTS(all_finite(samples) && all_finite(weights));
  const auto n = static_cast<double>(samples.size());
  const std::size_t stride = weights.size() == samples.size() ? 1 : 0;
  Moments result;
  result.n = samples.size();
  gsl_stats_minmax(&result.minimum, &result.maximum, samples.data(), 1, samples.size());
  result.mean = gsl_stats_wmean(weights.data(), stride, samples.data(), 1, samples.size());
  if (result.minimum == result.maximum) {
    result.mean = result.minimum;
    return result;
  }
  double total = 0.0, m2 = 0.0, m3 = 0.0, m4 = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double d = samples[i] - result.mean, wd2 = weights[i * stride] * d * d;
    total += weights[i * stride];
    m2 += wd2;
    m3 += wd2 * d;
    m4 += wd2 * d * d;
  }
  m2 /= total;
  result.variance = m2 * n / (n - 1.0);
  result.skewness = m3 / total / std::pow(m2, 1.5);
  result.excess_kurtosis = m4 / total / (m2 * m2) - 3.0;
  return result;
}

Histogram histogram(std::span<const double> samples, std::size_t n_bins, double lower, double upper) {
  BRASH_EXPECTS(n_bins > 0 && lower < upper, n_bins, lower, upper);
  BRASH_EXPECTS(all_finite(samples));
  quiet_gsl();
  const GslOwner<gsl_histogram, gsl_histogram_free> bins(gsl_histogram_alloc(n_bins));
  if (!bins) throw RunError("histogram: out of memory");
  check_gsl(gsl_histogram_set_ranges_uniform(bins.get(), lower, upper), "histogram");

  Histogram result;
  result.edges.assign(bins->range, bins->range + n_bins + 1);
  result.counts.assign(n_bins, 0);
  for (const double x : samples) {
    std::size_t bin = n_bins - 1;  // GSL leaves out the last upper edge
    if (x == upper || gsl_histogram_find(bins.get(), x, &bin) == 0) {
      ++result.counts[bin];
    } else {
      ++result.n_outside;
    }
  }
  return result;
}

}  // namespace brash::statistics
