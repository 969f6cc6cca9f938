// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
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
/// @see P. D. Welch, IEEE Trans. Audio Electroacoust. 15 (1967) 70; docs/theory/statistics.md, (S7).
Spectrum welch_spectrum(std::span<const double> samples, double dt, std::size_t segment);

/// The same over all segments that lie within pieces of a history; at least one piece is as long as `segment`.
Spectrum welch_spectrum(const Pieces& pieces, double dt, std::size_t segment);

/// Factors that turn a density into its confidence interval: chi squared with the spectrum's degrees of freedom.
Interval spectrum_factors(const Spectrum& spectrum, double confidence = 0.95);

/// How alike two spectra are, over the lines of `a` above zero and up to the lower of both last frequencies.
struct SpectrumComparison {
  std::vector<double> frequency;  ///< [Hz], shape=(n,)
  std::vector<double> ratio;      ///< density of a over density of b, shape=(n,)
  Interval band;                  ///< ratios of two estimates of one density lie in it, at the stated confidence
  double outside = 0.0;           ///< share of the lines whose ratio does not, about 1 - confidence for one density
  /// The same share when both have the same variance over these lines: only the shape is compared.
  double shape_outside = 0.0;
  double shape_correlation = 0.0;  ///< of the logarithms of the densities
  double mean_frequency_a = 0.0;   ///< density-weighted [Hz]
  double mean_frequency_b = 0.0;
};

/// Compares two estimates with chi-squared densities; `b` is interpolated where its lines are at other frequencies.
/// @return nothing when fewer than 3 lines are common or a density is zero.
std::optional<SpectrumComparison> compare_spectra(const Spectrum& a, const Spectrum& b, double confidence = 0.95);

}  // namespace brash::statistics
