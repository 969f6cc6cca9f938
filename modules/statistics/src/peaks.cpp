// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/peaks.hpp"

#include <algorithm>

#include "brash/core/contract.hpp"
#include "samples.hpp"

namespace brash::statistics {

std::vector<Peak> peaks_above(std::span<const double> samples, double threshold, std::size_t separation) {
  BRASH_EXPECTS(separation >= 1, separation);
  BRASH_EXPECTS(all_finite(samples));
  std::vector<Peak> peaks;
  std::size_t calm = separation;  // samples at or below the threshold since the last one above it
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i] <= threshold) {
      ++calm;
      continue;
    }
    if (calm >= separation) {
      peaks.push_back({i, samples[i]});
    } else if (samples[i] > peaks.back().value) {
      peaks.back() = {i, samples[i]};
    }
    calm = 0;
  }
  return peaks;
}

std::vector<Peak> peaks_between_crossings(std::span<const double> samples, double level) {
  BRASH_EXPECTS(all_finite(samples));
  std::vector<Peak> peaks;
  bool crossed = false;
  Peak peak;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (samples[i - 1] <= level && samples[i] > level) {
      if (crossed) peaks.push_back(peak);
      crossed = true;
      peak = {i, samples[i]};
    } else if (samples[i] > peak.value) {
      peak = {i, samples[i]};
    }
  }
  return peaks;
}

std::vector<double> block_maxima(std::span<const double> samples, std::size_t block) {
  BRASH_EXPECTS(block >= 1, block);
  BRASH_EXPECTS(all_finite(samples));
  std::vector<double> maxima;
  for (std::size_t start = 0; start + block <= samples.size(); start += block) {
    maxima.push_back(*std::ranges::max_element(samples.subspan(start, block)));
  }
  return maxima;
}

}  // namespace brash::statistics
