// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/summary.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fft_halfcomplex.h>
#include <gsl/gsl_fft_real.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "brash/core/contract.hpp"
#include "brash/statistics/history.hpp"
#include "brash/statistics/moments.hpp"
#include "brash/statistics/quantile.hpp"
#include "gsl_checked.hpp"
#include "samples.hpp"

namespace brash::statistics {
namespace {

constexpr double kWindowFactor = 5.0;       // Sokal's c: truncation bias e^-c, 0.7 %, for an exponential decay
constexpr std::size_t kFirstLags = 65'536;  // of the search for the window
constexpr double kLongEnough = 50.0;        // history in autocorrelation times; tau then errs by about two thirds

std::size_t total_size(const Pieces& pieces) {
  std::size_t n = 0;
  for (const auto piece : pieces) n += piece.size();
  return n;
}

/// Values less `mean`, transformed, in half-complex order: of frequency k the real part at k, the imaginary part at
/// `padded` - k.
std::vector<double> transformed(std::span<const double> values, double mean, std::size_t padded) {
  std::vector<double> work(padded, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) work[i] = values[i] - mean;
  check_gsl(gsl_fft_real_radix2_transform(work.data(), 1, padded), "autocorrelation");
  return work;
}

/// Adds a piece's sums of products of deviations from `mean` at lags 0, 1, ... to `sums`, by the fast Fourier
/// transform, padded against wrapping. A long piece is taken in parts, each against itself and the lags after it.
void add_products(std::span<const double> piece, double mean, std::vector<double>& sums) {
  constexpr std::size_t kPart = std::size_t{1} << 18;  // samples; more would need more room
  const std::size_t n = piece.size(), max_lag = std::min(sums.size(), n) - 1;
  for (std::size_t first = 0; first < n; first += kPart) {
    const std::span<const double> part = piece.subspan(first, std::min(kPart, n - first));
    const std::span<const double> whole = piece.subspan(first, std::min(part.size() + max_lag, n - first));
    std::size_t padded = 1;
    while (padded < part.size() + max_lag + 1) padded *= 2;
    std::vector<double> work = transformed(part, mean, padded);
    const std::vector<double> other = whole.size() == part.size() ? work : transformed(whole, mean, padded);
    work[0] *= other[0];
    if (padded > 1) work[padded / 2] *= other[padded / 2];
    for (std::size_t k = 1; 2 * k < padded; ++k) {
      const double real = work[k], imaginary = work[padded - k];
      work[k] = real * other[k] + imaginary * other[padded - k];
      work[padded - k] = real * other[padded - k] - imaginary * other[k];
    }
    check_gsl(gsl_fft_halfcomplex_radix2_inverse(work.data(), 1, padded), "autocorrelation");
    for (std::size_t k = 0; k <= std::min(max_lag, whole.size() - 1); ++k) sums[k] += work[k];
  }
}

double mean_of(const Pieces& pieces) {
  double sum = 0.0;
  for (const auto piece : pieces) {
    sum += static_cast<double>(piece.size()) * gsl_stats_mean(piece.data(), 1, piece.size());
  }
  return sum / static_cast<double>(total_size(pieces));
}

/// How many pairs of samples `lag` apart one piece of n samples has more than these pieces, as a factor.
double missing_pairs(const Pieces& pieces, std::size_t lag) {
  std::size_t pairs = 0;
  for (const auto piece : pieces) pairs += piece.size() > lag ? piece.size() - lag : 0;
  return static_cast<double>(total_size(pieces) - lag) / static_cast<double>(pairs);
}

}  // namespace

std::vector<double> autocorrelation(std::span<const double> samples, std::size_t max_lag) {
  return autocorrelation(Pieces{samples}, max_lag);
}

std::vector<double> autocorrelation(const Pieces& pieces, std::size_t max_lag) {
  BRASH_EXPECTS(total_size(pieces) >= 2, total_size(pieces));
  std::size_t longest = 0;
  double low = pieces.front()[0], high = low;
  for (const auto piece : pieces) {
    BRASH_EXPECTS(!piece.empty() && all_finite(piece));
    longest = std::max(longest, piece.size());
    const auto [least, largest] = std::ranges::minmax(piece);
    low = std::min(low, least);
    high = std::max(high, largest);
  }
  BRASH_EXPECTS(max_lag < longest, longest, max_lag);
  quiet_gsl();
  std::vector<double> rho(max_lag + 1, 0.0);
  rho[0] = 1.0;
  if (low == high) return rho;
  std::vector<double> sums(max_lag + 1, 0.0);
  const double mean = mean_of(pieces);
  for (const auto piece : pieces) add_products(piece, mean, sums);
  for (std::size_t k = 1; k <= max_lag; ++k) {
    rho[k] = sums[k] / sums[0];
    if (pieces.size() > 1) rho[k] *= missing_pairs(pieces, k);
  }
  return rho;
}

AutocorrelationTime autocorrelation_time(std::span<const double> samples, double dt) {
  return autocorrelation_time(Pieces{samples}, dt);
}

AutocorrelationTime autocorrelation_time(const Pieces& pieces, double dt) {
  BRASH_EXPECTS(dt > 0.0, dt);
  BRASH_EXPECTS(!pieces.empty());
  const std::size_t n = total_size(pieces);
  const auto longest = std::ranges::max(pieces, {}, [](const auto piece) { return piece.size(); }).size();
  const std::size_t most = std::min(n / 2, longest - 1);
  AutocorrelationTime result;
  double tau = 0.0;
  // The window seldom needs more than a few thousand lags, and lags take time.
  for (std::size_t lags = std::min(kFirstLags, most); !result.converged; lags = std::min(8 * lags, most)) {
    const std::vector<double> rho = autocorrelation(pieces, lags);
    tau = 0.5;
    for (std::size_t window = 1; window < rho.size() && !result.converged; ++window) {
      tau += rho[window];
      result.window = window;
      result.converged = static_cast<double>(window) >= kWindowFactor * tau;
    }
    if (lags == most) break;
  }
  const double w = static_cast<double>(result.window);
  tau *= 1.0 + (2.0 * w + 1.0) / static_cast<double>(n);
  result.tau = dt * std::max(0.5, tau);
  return result;
}

Summary summarise(std::span<const double> samples, double dt) {
  History history{std::vector<double>(samples.size()), {samples.begin(), samples.end()}};
  for (std::size_t i = 0; i < samples.size(); ++i) history.times[i] = dt * static_cast<double>(i);
  EvenHistory even;
  even.sampling.step = even.sampling.shortest = even.sampling.longest = dt;
  even.weights = {dt};
  even.cuts = {0, samples.size()};
  even.duration = dt * static_cast<double>(samples.size());
  return summarise(history, even);
}

Summary summarise_weighted(std::span<const double> samples, std::span<const double> weights,
                           const AutocorrelationTime& correlation) {
  quiet_gsl();
  const Moments m = moments(samples, weights);
  const std::vector<double> q = quantiles(samples, weights, std::array{0.01, 0.50, 0.95, 0.99});
  Summary summary;
  summary.n = m.n;
  summary.mean = m.mean;
  summary.standard_deviation = std::sqrt(m.variance);
  summary.minimum = m.minimum;
  summary.maximum = m.maximum;
  summary.skewness = m.skewness;
  summary.excess_kurtosis = m.excess_kurtosis;
  summary.quantile_1 = q[0];
  summary.quantile_50 = q[1];
  summary.quantile_95 = q[2];
  summary.quantile_99 = q[3];

  const auto n = static_cast<double>(m.n);
  double duration = 0.0;
  for (std::size_t i = 0; i < m.n; ++i) duration += weights[weights.size() == 1 ? 0 : i];
  summary.autocorrelation_time = correlation.tau;
  summary.effective_sample_size = std::clamp(duration / (2.0 * correlation.tau), 1.0, n);
  summary.long_enough = correlation.converged && duration >= kLongEnough * correlation.tau;
  const double freedom = std::max(1.0, summary.effective_sample_size - 1.0);
  const double half_width =
      gsl_cdf_tdist_Pinv(0.975, freedom) * summary.standard_deviation / std::sqrt(summary.effective_sample_size);
  summary.mean_95 = {summary.mean - half_width, summary.mean + half_width};
  return summary;
}

}  // namespace brash::statistics
