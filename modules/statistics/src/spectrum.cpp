// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/spectrum.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fft_real.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "gsl_checked.hpp"
#include "samples.hpp"

namespace brash::statistics {
namespace {

/// Real transforms of one length.
class RealTransform {
 public:
  explicit RealTransform(std::size_t n)
      : n_(n), table_(gsl_fft_real_wavetable_alloc(n)), work_(gsl_fft_real_workspace_alloc(n)) {
    if (!table_ || !work_) throw RunError("spectrum: out of memory");
  }
  /// In place, half-complex order: re 0, re 1, im 1, re 2, ...
  void operator()(std::vector<double>& data) const {
    check_gsl(gsl_fft_real_transform(data.data(), 1, n_, table_.get(), work_.get()), "spectrum");
  }

 private:
  std::size_t n_;
  GslOwner<gsl_fft_real_wavetable, gsl_fft_real_wavetable_free> table_;
  GslOwner<gsl_fft_real_workspace, gsl_fft_real_workspace_free> work_;
};

/// Hann's window with the period of the segment, as spectra want it.
std::vector<double> hann(std::size_t n) {
  std::vector<double> window(n);
  for (std::size_t i = 0; i < n; ++i) {
    window[i] = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n));
  }
  return window;
}

/// Adds the squared transform of a segment, without its mean and under the window, to the lines of `power`.
void add_power(std::span<const double> segment, const std::vector<double>& window, const RealTransform& transform,
               std::vector<double>& power) {
  const std::size_t n = segment.size();
  const double mean = gsl_stats_mean(segment.data(), 1, n);
  std::vector<double> data(n);
  for (std::size_t i = 0; i < n; ++i) data[i] = window[i] * (segment[i] - mean);
  transform(data);
  power[0] += data[0] * data[0];
  for (std::size_t k = 1; k < power.size(); ++k) {
    const double real = data[2 * k - 1];
    const double imaginary = 2 * k < n ? data[2 * k] : 0.0;
    power[k] += real * real + imaginary * imaginary;
  }
}

}  // namespace

Spectrum welch_spectrum(std::span<const double> samples, double dt, std::size_t segment) {
  return welch_spectrum(Pieces{samples}, dt, segment);
}

Spectrum welch_spectrum(const Pieces& pieces, double dt, std::size_t segment) {
  BRASH_EXPECTS(segment >= 4 && dt > 0.0, segment, dt);
  // Before anything of that size is made.
  BRASH_EXPECTS(std::ranges::any_of(pieces, [&](const auto piece) { return piece.size() >= segment; }), segment);
  quiet_gsl();
  const RealTransform transform(segment);
  const std::vector<double> window = hann(segment);
  double window_power = 0.0;
  for (const double w : window) window_power += w * w;

  Spectrum spectrum;
  spectrum.density.assign(segment / 2 + 1, 0.0);
  const std::size_t step = segment - segment / 2;
  std::size_t n_used = 0;  // pieces
  for (const auto piece : pieces) {
    BRASH_EXPECTS(all_finite(piece));
    n_used += piece.size() >= segment ? 1 : 0;
    for (std::size_t start = 0; start + segment <= piece.size(); start += step) {
      add_power(piece.subspan(start, segment), window, transform, spectrum.density);
      ++spectrum.n_segments;
    }
  }

  const double scale = dt / (window_power * static_cast<double>(spectrum.n_segments));
  for (std::size_t k = 0; k < spectrum.density.size(); ++k) {
    // Two-sided power on one side, except at zero and at the Nyquist frequency.
    const bool paired = k > 0 && 2 * k < segment;
    spectrum.density[k] *= paired ? 2.0 * scale : scale;
    spectrum.frequency.push_back(static_cast<double>(k) / (static_cast<double>(segment) * dt));
  }
  // Neighbours in a piece share a correlation of 1/6, squared 1/36: nu = 2 K / (1 + 2 (K - pieces)/K / 36).
  const auto n = static_cast<double>(spectrum.n_segments);
  spectrum.degrees_of_freedom = 36.0 * n * n / (19.0 * n - static_cast<double>(n_used));
  return spectrum;
}

Interval spectrum_factors(const Spectrum& spectrum, double confidence) {
  BRASH_EXPECTS(confidence > 0.0 && confidence < 1.0, confidence);
  BRASH_EXPECTS(spectrum.degrees_of_freedom > 0.0, spectrum.degrees_of_freedom);
  quiet_gsl();
  const double nu = spectrum.degrees_of_freedom;
  return {nu / gsl_cdf_chisq_Pinv(0.5 + 0.5 * confidence, nu), nu / gsl_cdf_chisq_Pinv(0.5 - 0.5 * confidence, nu)};
}

std::optional<SpectrumComparison> compare_spectra(const Spectrum& a, const Spectrum& b, double confidence) {
  BRASH_EXPECTS(confidence > 0.0 && confidence < 1.0, confidence);
  quiet_gsl();
  const double lowest = b.frequency[1];
  const double highest = std::min(a.frequency.back(), b.frequency.back()) * (1.0 + 1e-9);
  SpectrumComparison result;
  std::vector<double> of_a, of_b;
  for (std::size_t k = 1, next = 1; k < a.frequency.size(); ++k) {
    const double f = a.frequency[k];
    if (f < lowest * (1.0 - 1e-9) || f > highest) continue;
    while (next + 1 < b.frequency.size() && b.frequency[next] < f) ++next;
    const double share =
        std::clamp((f - b.frequency[next - 1]) / (b.frequency[next] - b.frequency[next - 1]), 0.0, 1.0);
    of_a.push_back(a.density[k]);
    of_b.push_back(b.density[next - 1] + share * (b.density[next] - b.density[next - 1]));
    if (!(of_a.back() > 0.0 && of_b.back() > 0.0)) return std::nullopt;
    result.frequency.push_back(f);
    result.ratio.push_back(of_a.back() / of_b.back());
  }
  const std::size_t n = result.ratio.size();
  if (n < 3) return std::nullopt;

  const double nu_a = a.degrees_of_freedom, nu_b = b.degrees_of_freedom;
  result.band = {gsl_cdf_fdist_Pinv(0.5 - 0.5 * confidence, nu_a, nu_b),
                 gsl_cdf_fdist_Pinv(0.5 + 0.5 * confidence, nu_a, nu_b)};
  const double sum_a = std::accumulate(of_a.begin(), of_a.end(), 0.0);
  const double sum_b = std::accumulate(of_b.begin(), of_b.end(), 0.0);
  const auto is_outside = [&](double ratio) { return ratio < result.band.lower || ratio > result.band.upper; };
  std::vector<double> log_a(n), log_b(n);
  for (std::size_t k = 0; k < n; ++k) {
    const double one = 1.0 / static_cast<double>(n);
    if (is_outside(result.ratio[k])) result.outside += one;
    if (is_outside(result.ratio[k] * sum_b / sum_a)) result.shape_outside += one;
    result.mean_frequency_a += result.frequency[k] * of_a[k] / sum_a;
    result.mean_frequency_b += result.frequency[k] * of_b[k] / sum_b;
    log_a[k] = std::log(of_a[k]);
    log_b[k] = std::log(of_b[k]);
  }
  result.shape_correlation = gsl_stats_correlation(log_a.data(), 1, log_b.data(), 1, n);
  return result;
}

}  // namespace brash::statistics
