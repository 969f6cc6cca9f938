// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/filter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "brash/core/contract.hpp"
#include "samples.hpp"

namespace brash::statistics {
namespace {

using std::numbers::pi;
using std::numbers::sqrt2;

constexpr std::size_t kReflected = 9;  // samples at each end; as SciPy's filtfilt for two poles

/// Butterworth's filter of second order by the bilinear transform; docs/theory/statistics.md, (S13).
struct Section {
  double b0, b1, b2, a1, a2;

  Section(double dt, double cut_off) {
    const double k = std::tan(pi * cut_off * dt), norm = 1.0 / (1.0 + sqrt2 * k + k * k);
    b0 = b2 = k * k * norm;
    b1 = 2.0 * b0;
    a1 = 2.0 * (k * k - 1.0) * norm;
    a2 = (1.0 - sqrt2 * k + k * k) * norm;
  }

  /// Filters in place, from the state of a load that has always been the first sample.
  template <typename Iterator>
  void run(Iterator first, Iterator last) const {
    double z2 = (b2 - a2) * *first, z1 = (b1 - a1) * *first + z2;
    for (; first != last; ++first) {
      const double in = *first, out = b0 * in + z1;
      z1 = b1 * in - a1 * out + z2;
      z2 = b2 * in - a2 * out;
      *first = out;
    }
  }
};

/// The samples with odd reflections at both ends.
std::vector<double> reflected(std::span<const double> samples, std::size_t n) {
  std::vector<double> padded;
  padded.reserve(samples.size() + 2 * n);
  for (std::size_t i = n; i > 0; --i) padded.push_back(2.0 * samples.front() - samples[i]);
  padded.insert(padded.end(), samples.begin(), samples.end());
  for (std::size_t i = 1; i <= n; ++i) padded.push_back(2.0 * samples.back() - samples[samples.size() - 1 - i]);
  return padded;
}

}  // namespace

std::vector<double> low_pass(std::span<const double> samples, double dt, double cut_off, Phase phase) {
  BRASH_EXPECTS(!samples.empty() && all_finite(samples), samples.size());
  BRASH_EXPECTS(dt > 0.0 && cut_off > 0.0 && cut_off * dt < 0.5, dt, cut_off);
  if (phase == Phase::kCausal) {
    std::vector<double> filtered(samples.begin(), samples.end());
    Section(dt, cut_off).run(filtered.begin(), filtered.end());
    return filtered;
  }
  // Two passes at a higher cut-off leave 1/sqrt(2) at the one that is asked for: tan' = tan / (sqrt(2) - 1)^(1/4).
  const double higher = std::atan(std::tan(pi * cut_off * dt) / std::pow(sqrt2 - 1.0, 0.25)) / (pi * dt);
  const std::size_t n = std::min(kReflected, samples.size() - 1);
  std::vector<double> padded = reflected(samples, n);
  const Section section(dt, higher);
  section.run(padded.begin(), padded.end());
  section.run(padded.rbegin(), padded.rend());
  return {padded.begin() + static_cast<std::ptrdiff_t>(n), padded.end() - static_cast<std::ptrdiff_t>(n)};
}

double low_pass_delay(double cut_off, Phase phase) {
  BRASH_EXPECTS(cut_off > 0.0, cut_off);
  return phase == Phase::kZero ? 0.0 : sqrt2 / (2.0 * pi * cut_off);
}

}  // namespace brash::statistics
