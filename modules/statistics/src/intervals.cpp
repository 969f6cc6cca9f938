// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/intervals.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
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

std::size_t values_for_half_interval(std::size_t n, double confidence) {
  BRASH_EXPECTS(n >= 2, n);
  BRASH_EXPECTS(confidence > 0.0 && confidence < 1.0, confidence);
  quiet_gsl();
  const auto width = [&](std::size_t m) {
    const auto count = static_cast<double>(m);
    return gsl_cdf_tdist_Pinv(0.5 + 0.5 * confidence, count - 1.0) / std::sqrt(count);
  };
  // Four times the values always do: the quantile falls with their number.
  std::size_t too_few = n, enough = 4 * n;
  while (enough - too_few > 1) {
    const std::size_t middle = too_few + (enough - too_few) / 2;
    (width(middle) > 0.5 * width(n) ? too_few : enough) = middle;
  }
  return enough;
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

namespace {

/// Groups of blocks of which the jackknife leaves out one after the other, at most.
constexpr std::size_t kGroups = 40;

/// A statistic of a sample, and of the sample without each of its groups.
struct Estimate {
  double value = 0.0;
  std::vector<double> without;

  bool is_positive() const {
    return value > 0.0 && std::ranges::all_of(without, [](double v) { return v > 0.0; });
  }
  Estimate logarithm() const {
    Estimate log{std::log(value), without};
    for (double& v : log.without) v = std::log(v);
    return log;
  }
  /// The jackknife's, for as many groups as there are.
  double error() const {
    const auto g = static_cast<double>(without.size());
    const double mean = gsl_stats_mean(without.data(), 1, without.size());
    double sum = 0.0;
    for (const double v : without) sum += (v - mean) * (v - mean);
    return std::sqrt((g - 1.0) / g * sum);
  }
};

/// How far draws lie from the original, in their own errors.
struct Studentised {
  Estimate original;
  std::vector<double> deviations{};

  void add(const Estimate& draw) {
    if (const double error = draw.error(); error > 0.0) deviations.push_back((draw.value - original.value) / error);
  }
  Interval interval(double confidence) const {
    const std::array<double, 2> levels{0.5 - 0.5 * confidence, 0.5 + 0.5 * confidence};
    std::vector<double> ends{0.0, 0.0};
    if (!deviations.empty()) ends = quantiles(deviations, levels);
    return {original.value - ends[1] * original.error(), original.value - ends[0] * original.error()};
  }
};

/// The estimate from `samples`, a row of blocks.
Estimate estimate(std::span<const double> samples, std::size_t block_length,
                  const std::function<double(std::span<const double>)>& statistic) {
  Estimate made{statistic(samples), {}};
  const std::size_t n_blocks = std::max<std::size_t>(samples.size() / block_length, 2);
  const std::size_t n_groups = std::min(n_blocks, kGroups);
  std::vector<double> rest;
  for (std::size_t g = 0; g < n_groups; ++g) {
    const auto from = static_cast<std::ptrdiff_t>(samples.size() * g / n_groups);
    const auto to = static_cast<std::ptrdiff_t>(samples.size() * (g + 1) / n_groups);
    rest.assign(samples.begin(), samples.begin() + from);
    rest.insert(rest.end(), samples.begin() + to, samples.end());
    made.without.push_back(statistic(rest));
  }
  return made;
}

}  // namespace

Interval bootstrap_interval(std::span<const double> samples,
                            const std::function<double(std::span<const double>)>& statistic,
                            const BootstrapSettings& settings, RandomStream& stream) {
  const std::size_t n = samples.size();
  BRASH_EXPECTS(n >= 2 && settings.block_length >= 1 && settings.block_length <= n, n, settings.block_length);
  BRASH_EXPECTS(settings.n_resamples >= 2, settings.n_resamples);
  BRASH_EXPECTS(settings.confidence > 0.0 && settings.confidence < 1.0, settings.confidence);
  BRASH_EXPECTS(all_finite(samples));
  quiet_gsl();

  Studentised plain{estimate(samples, settings.block_length, statistic)};
  std::optional<Studentised> logarithmic;
  if (plain.original.is_positive()) logarithmic = Studentised{plain.original.logarithm()};
  std::vector<double> resample(n);
  for (std::size_t r = 0; r < settings.n_resamples; ++r) {
    for (std::size_t filled = 0; filled < n;) {
      const auto start = static_cast<std::size_t>(stream.uniform() * static_cast<double>(n));
      for (std::size_t k = 0; k < settings.block_length && filled < n; ++k) {
        resample[filled++] = samples[(start + k) % n];
      }
    }
    const Estimate draw = estimate(resample, settings.block_length, statistic);
    plain.add(draw);
    if (!draw.is_positive()) logarithmic.reset();
    if (logarithmic) logarithmic->add(draw.logarithm());
  }
  if (!logarithmic) return plain.interval(settings.confidence);
  const Interval interval = logarithmic->interval(settings.confidence);
  return {std::exp(interval.lower), std::exp(interval.upper)};
}

}  // namespace brash::statistics
