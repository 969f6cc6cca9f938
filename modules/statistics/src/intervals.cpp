// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/intervals.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "brash/core/contract.hpp"
#include "brash/statistics/quantile.hpp"
#include "gsl_checked.hpp"
#include "samples.hpp"

namespace brash::statistics {

Interval mean_interval(std::span<const double> independent, double confidence) {
  BRASH_EXPECTS(independent.size() >= 2, independent.size());
  BRASH_EXPECTS(confidence > 0.0 && confidence < 1.0, confidence);
  BRASH_EXPECTS(all_finite(independent));
  quiet_gsl();
  const std::size_t n = independent.size();
  const double mean = gsl_stats_mean(independent.data(), 1, n);
  const double error = gsl_stats_sd_m(independent.data(), 1, n, mean) / std::sqrt(static_cast<double>(n));
  const double t = gsl_cdf_tdist_Pinv(0.5 + 0.5 * confidence, static_cast<double>(n - 1));
  return {mean - t * error, mean + t * error};
}

Interval batch_means_interval(std::span<const double> samples, std::size_t n_batches, double confidence) {
  BRASH_EXPECTS(n_batches >= 2 && n_batches <= samples.size(), n_batches, samples.size());
  const std::size_t length = samples.size() / n_batches;
  const std::span<const double> used = samples.last(length * n_batches);
  std::vector<double> means(n_batches);
  for (std::size_t i = 0; i < n_batches; ++i) means[i] = gsl_stats_mean(used.data() + i * length, 1, length);
  return mean_interval(means, confidence);
}

std::size_t block_length(double tau_in_samples, std::size_t n) {
  BRASH_EXPECTS(tau_in_samples >= 0.5, tau_in_samples);
  BRASH_EXPECTS(n > 0);
  const double memory = tau_in_samples - 0.25 / tau_in_samples;
  const double length = std::cbrt(1.5 * memory * memory * static_cast<double>(n));
  return std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(length)), 1, n);
}

Interval bootstrap_interval(std::span<const double> samples,
                            const std::function<double(std::span<const double>)>& statistic,
                            const BootstrapSettings& settings, RandomStream& stream) {
  const std::size_t n = samples.size();
  BRASH_EXPECTS(n >= 2 && settings.block_length >= 1 && settings.block_length <= n, n, settings.block_length);
  BRASH_EXPECTS(settings.n_resamples >= 2, settings.n_resamples);
  BRASH_EXPECTS(settings.confidence > 0.0 && settings.confidence < 1.0, settings.confidence);
  BRASH_EXPECTS(all_finite(samples));

  std::vector<double> resample(n), values;
  values.reserve(settings.n_resamples);
  for (std::size_t r = 0; r < settings.n_resamples; ++r) {
    for (std::size_t filled = 0; filled < n;) {
      const auto start = static_cast<std::size_t>(stream.uniform() * static_cast<double>(n));
      for (std::size_t k = 0; k < settings.block_length && filled < n; ++k) {
        resample[filled++] = samples[(start + k) % n];
      }
    }
    values.push_back(statistic(resample));
  }
  const std::array<double, 2> levels{0.5 - 0.5 * settings.confidence, 0.5 + 0.5 * settings.confidence};
  const std::vector<double> ends = quantiles(std::move(values), levels);
  return {ends[0], ends[1]};
}

}  // namespace brash::statistics
