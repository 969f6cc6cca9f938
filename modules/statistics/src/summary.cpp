// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/summary.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fft_halfcomplex.h>
#include <gsl/gsl_fft_real.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>

#include "brash/core/contract.hpp"
#include "gsl_checked.hpp"
#include "samples.hpp"

namespace brash::statistics {
namespace {

constexpr double kWindowFactor = 5.0;  // Sokal's c: truncation bias e^-c, 0.7 %, for an exponential decay
constexpr double kLongEnough = 50.0;   // history in autocorrelation times for tau to be known to about 30 %

/// Sums of products of the deviations at lags 0 to max_lag, by the fast Fourier transform, padded against wrapping.
std::vector<double> autocovariance_sums(std::span<const double> samples, std::size_t max_lag) {
  const std::size_t n = samples.size();
  std::size_t padded = 1;
  while (padded < n + max_lag + 1) padded *= 2;
  const double mean = gsl_stats_mean(samples.data(), 1, n);
  std::vector<double> work(padded, 0.0);
  for (std::size_t i = 0; i < n; ++i) work[i] = samples[i] - mean;

  check_gsl(gsl_fft_real_radix2_transform(work.data(), 1, padded), "autocorrelation");
  // Half-complex order: real part of frequency k at k, imaginary part at padded - k.
  work[0] *= work[0];
  if (padded > 1) work[padded / 2] *= work[padded / 2];
  for (std::size_t k = 1; 2 * k < padded; ++k) {
    work[k] = work[k] * work[k] + work[padded - k] * work[padded - k];
    work[padded - k] = 0.0;
  }
  check_gsl(gsl_fft_halfcomplex_radix2_inverse(work.data(), 1, padded), "autocorrelation");
  work.resize(max_lag + 1);
  return work;
}

double central_skewness(std::span<const double> samples, double mean) {
  double m2 = 0.0, m3 = 0.0;
  for (const double x : samples) {
    const double d = x - mean;
    m2 += d * d;
    m3 += d * d * d;
  }
  const double n = static_cast<double>(samples.size());
  return m2 > 0.0 ? (m3 / n) / std::pow(m2 / n, 1.5) : 0.0;
}

}  // namespace

std::vector<double> autocorrelation(std::span<const double> samples, std::size_t max_lag) {
  BRASH_EXPECTS(samples.size() >= 2 && max_lag < samples.size(), samples.size(), max_lag);
  BRASH_EXPECTS(all_finite(samples));
  quiet_gsl();
  std::vector<double> rho(max_lag + 1, 0.0);
  const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
  rho[0] = 1.0;
  if (*low == *high) return rho;
  const std::vector<double> sums = autocovariance_sums(samples, max_lag);
  for (std::size_t k = 1; k <= max_lag; ++k) rho[k] = sums[k] / sums[0];
  return rho;
}

AutocorrelationTime autocorrelation_time(std::span<const double> samples, double dt) {
  BRASH_EXPECTS(dt > 0.0, dt);
  const std::size_t n = samples.size();
  const std::vector<double> rho = autocorrelation(samples, n / 2);
  AutocorrelationTime result;
  double tau = 0.5;
  for (std::size_t window = 1; window < rho.size(); ++window) {
    tau += rho[window];
    result.window = window;
    if (static_cast<double>(window) >= kWindowFactor * tau) {
      result.converged = true;
      break;
    }
  }
  const double w = static_cast<double>(result.window);
  tau *= 1.0 + (2.0 * w + 1.0) / static_cast<double>(n);
  result.tau = dt * std::max(0.5, tau);
  return result;
}

Summary summarise(std::span<const double> samples, double dt) {
  const AutocorrelationTime correlation = autocorrelation_time(samples, dt);
  const std::size_t n = samples.size();
  Summary summary;
  summary.n = n;
  summary.mean = gsl_stats_mean(samples.data(), 1, n);
  summary.standard_deviation = gsl_stats_sd_m(samples.data(), 1, n, summary.mean);
  summary.skewness = central_skewness(samples, summary.mean);

  std::vector<double> sorted(samples.begin(), samples.end());
  std::sort(sorted.begin(), sorted.end());
  const auto quantile = [&](double f) { return gsl_stats_quantile_from_sorted_data(sorted.data(), 1, n, f); };
  summary.minimum = sorted.front();
  summary.maximum = sorted.back();
  summary.quantile_50 = quantile(0.50);
  summary.quantile_95 = quantile(0.95);
  summary.quantile_99 = quantile(0.99);

  const double duration = static_cast<double>(n) * dt;
  summary.autocorrelation_time = correlation.tau;
  summary.effective_sample_size = std::clamp(duration / (2.0 * correlation.tau), 1.0, static_cast<double>(n));
  summary.long_enough = correlation.converged && duration >= kLongEnough * correlation.tau;
  const double freedom = std::max(1.0, summary.effective_sample_size - 1.0);
  const double half_width =
      gsl_cdf_tdist_Pinv(0.975, freedom) * summary.standard_deviation / std::sqrt(summary.effective_sample_size);
  summary.mean_95 = {summary.mean - half_width, summary.mean + half_width};
  return summary;
}

}  // namespace brash::statistics
