// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/spectrum.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fft_real.h>
#include <gsl/gsl_statistics_double.h>

#include <cmath>
#include <numbers>

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
  BRASH_EXPECTS(spectrum.n_segments > 0, segment);

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

}  // namespace brash::statistics
