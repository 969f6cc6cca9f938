// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "brash/statistics/summary.hpp"

namespace brash::statistics {

/// One-sided power spectral density; its integral over frequency is the variance.
struct Spectrum {
  std::vector<double> frequency;  ///< [Hz], shape=(segment / 2 + 1,)
  std::vector<double> density;    ///< [N2/Hz], same shape
  std::size_t n_segments = 0;
  double degrees_of_freedom = 0.0;  ///< of each density, for segments that overlap by half
};

/// Welch's estimate: segments that overlap by half, each without its mean and under a Hann window.
///
/// @param samples  shape=(n,), evenly sampled every `dt` [s].
/// @param segment  samples in a segment, 4 to n.
/// @see P. D. Welch, IEEE Trans. Audio Electroacoust. 15 (1967) 70.
Spectrum welch_spectrum(std::span<const double> samples, double dt, std::size_t segment);

/// The same over all segments that lie within pieces of a history; at least one piece is as long as `segment`.
Spectrum welch_spectrum(const Pieces& pieces, double dt, std::size_t segment);

/// Factors that turn a density into its confidence interval: chi squared with the spectrum's degrees of freedom.
Interval spectrum_factors(const Spectrum& spectrum, double confidence = 0.95);

}  // namespace brash::statistics
