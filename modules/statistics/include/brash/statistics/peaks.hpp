// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace brash::statistics {

/// A local event of a load history.
struct Peak {
  std::size_t index = 0;  ///< of the sample; time = start + index dt
  double value = 0.0;
};

/// The largest sample of each excursion above `threshold`. Excursions with fewer than `separation` samples at or below
/// the threshold between them are one (runs declustering), so that a rattling contact is not counted twice.
///
/// @param separation  at least 1.
std::vector<Peak> peaks_above(std::span<const double> samples, double threshold, std::size_t separation = 1);

/// The largest sample between each two successive upward crossings of `level` (the zero-crossing method when level is
/// the mean). The pieces before the first and after the last crossing are left out: they are not whole.
std::vector<Peak> peaks_between_crossings(std::span<const double> samples, double level);

/// The largest sample of each block of `block` samples; an incomplete last block is left out.
std::vector<double> block_maxima(std::span<const double> samples, std::size_t block);

}  // namespace brash::statistics
