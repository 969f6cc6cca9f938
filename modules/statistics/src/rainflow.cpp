// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/rainflow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "brash/core/contract.hpp"
#include "brash/statistics/laws.hpp"
#include "brash/statistics/quantile.hpp"
#include "samples.hpp"

namespace brash::statistics {
namespace {

constexpr int kResamples = 1000;
constexpr double kSmall = 1.0 / 3.0;  // of the largest range
constexpr std::size_t kFewestInTail = 10;
constexpr std::size_t kMostInTail = 40;  // of a short record; of a long one a tenth

struct Reversal {
  double value = 0.0;
  std::size_t index = 0;
};

/// Peaks and valleys between the first and the last sample, and both of these.
std::vector<Reversal> reversals(std::span<const double> samples) {
  std::vector<Reversal> found;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double value = samples[i];
    if (!found.empty() && found.back().value == value) continue;
    const std::size_t n = found.size();
    const bool goes_on = n >= 2 && (found[n - 1].value > found[n - 2].value) == (value > found[n - 1].value);
    if (goes_on) found.pop_back();
    found.push_back({value, i});
  }
  return found;
}

Cycle cycle(const Reversal& from, const Reversal& to, double count) {
  return {std::abs(to.value - from.value), 0.5 * (from.value + to.value), count, to.index};
}

/// Sums over a resample of stretches.
struct Sums {
  double n = 0.0, damage = 0.0, length = 0.0;
  double damage_squared = 0.0, length_squared = 0.0, product = 0.0;

  void add(double d, double l) {
    n += 1.0;
    damage += d;
    length += l;
    damage_squared += d * d;
    length_squared += l * l;
    product += d * l;
  }
  double ratio() const { return damage / length; }
  /// Relative error of the ratio of the sums.
  double error() const {
    const double r = ratio();
    const double residuals = damage_squared - 2.0 * r * product + r * r * length_squared;
    return std::sqrt(std::max(0.0, residuals * n / (n - 1.0))) / damage;
  }
};

}  // namespace

std::vector<Cycle> rainflow(std::span<const double> samples) {
  BRASH_EXPECTS(all_finite(samples));
  std::vector<Cycle> cycles;
  std::vector<Reversal> open;
  for (const Reversal& reversal : reversals(samples)) {
    open.push_back(reversal);
    while (open.size() >= 3) {
      const std::size_t n = open.size();
      const double newest = std::abs(open[n - 1].value - open[n - 2].value);
      if (newest < std::abs(open[n - 2].value - open[n - 3].value)) break;
      cycles.push_back(cycle(open[n - 3], open[n - 2], n == 3 ? 0.5 : 1.0));
      if (n == 3)
        open.erase(open.begin());
      else
        open.erase(open.end() - 3, open.end() - 1);
    }
  }
  for (std::size_t i = 1; i < open.size(); ++i) cycles.push_back(cycle(open[i - 1], open[i], 0.5));
  return cycles;
}

double damage(std::span<const Cycle> cycles, double exponent) {
  BRASH_EXPECTS(exponent >= 1.0, exponent);
  double sum = 0.0;
  for (const Cycle& c : cycles) sum += c.count * std::pow(c.range, exponent);
  return sum;
}

double damage_equivalent_load(double damage, double exponent, double duration, double frequency) {
  BRASH_EXPECTS(damage >= 0.0 && exponent >= 1.0, damage, exponent);
  BRASH_EXPECTS(duration > 0.0 && frequency > 0.0, duration, frequency);
  return std::pow(damage / (frequency * duration), 1.0 / exponent);
}

StretchDamages damage_by_stretch(std::span<const Cycle> cycles, double exponent, std::size_t n_samples,
                                 std::size_t stretch) {
  BRASH_EXPECTS(stretch >= 1 && n_samples >= 1, stretch, n_samples);
  BRASH_EXPECTS(exponent >= 1.0, exponent);
  const std::size_t n = std::max<std::size_t>(1, n_samples / stretch);
  StretchDamages result{std::vector<double>(n, 0.0), std::vector<double>(n, static_cast<double>(stretch))};
  result.lengths.back() = static_cast<double>(n_samples - (n - 1) * stretch);
  for (const Cycle& c : cycles)
    result.damages[std::min(c.index / stretch, n - 1)] += c.count * std::pow(c.range, exponent);
  return result;
}

Interval damage_rate_interval(const StretchDamages& stretches, double confidence, RandomStream& stream) {
  const std::size_t n = stretches.damages.size();
  BRASH_EXPECTS(n >= 2 && stretches.lengths.size() == n, n);
  BRASH_EXPECTS(confidence > 0.0 && confidence < 1.0, confidence);
  Sums all;
  for (std::size_t i = 0; i < n; ++i) all.add(stretches.damages[i], stretches.lengths[i]);
  BRASH_EXPECTS(all.damage > 0.0, all.damage);
  const double error = all.error();
  if (error == 0.0) return {all.ratio(), all.ratio()};

  std::vector<double> distances;  // of the logarithm, in errors
  for (int r = 0; r < kResamples; ++r) {
    Sums sums;
    for (std::size_t i = 0; i < n; ++i) {
      const auto drawn = static_cast<std::size_t>(stream.uniform() * static_cast<double>(n));
      sums.add(stretches.damages[drawn], stretches.lengths[drawn]);
    }
    if (sums.damage > 0.0 && sums.error() > 0.0)
      distances.push_back(std::log(sums.ratio() / all.ratio()) / sums.error());
  }
  if (distances.size() < kResamples / 2) return {0.0, std::numeric_limits<double>::infinity()};
  const std::array<double, 2> levels{0.5 + 0.5 * confidence, 0.5 - 0.5 * confidence};
  const std::vector<double> ends = quantiles(std::move(distances), levels);
  return {all.ratio() * std::exp(-ends[0] * error), all.ratio() * std::exp(-ends[1] * error)};
}

double unseen_damage(std::span<const Cycle> cycles, double exponent) {
  BRASH_EXPECTS(exponent >= 1.0, exponent);
  const double largest = cycles.empty() ? 0.0 : std::ranges::max(cycles, {}, &Cycle::range).range;
  std::vector<double> ranges;  // without the small ones, such as of noise
  for (const Cycle& c : cycles)
    if (c.range > kSmall * largest) ranges.push_back(c.range);
  const std::size_t n = ranges.size();
  const std::size_t over = std::min(n / 2, std::max(n / 10, kMostInTail));
  if (over < kFewestInTail) return 1.0;
  std::ranges::sort(ranges);
  const double threshold = ranges[n - over - 1];
  const auto fit = fit_law(Law::kPareto, std::span(ranges).last(over), threshold);
  if (!fit) return 0.0;
  Distribution tail = fit->distribution;
  if (tail.shape < 0.0) {
    // The end of a tail is seldom known: an exponential one is on the safe side.
    tail.scale = 0.0;
    for (const double range : fit->values) tail.scale += (range - threshold) / static_cast<double>(fit->values.size());
    tail.shape = 0.0;
  }
  if (tail.shape * exponent >= 1.0) return 1.0;
  // Integral of range^exponent over the probability beyond the largest range, in steps of its logarithm.
  constexpr double kStep = 0.05, kFarthest = 60.0;
  const double beyond = tail.exceedance(largest);
  double unseen = 0.0;
  for (double s = 0.5 * kStep; s < kFarthest && beyond > 0.0; s += kStep)
    unseen += kStep * beyond * std::exp(-s) * std::pow(tail.level(beyond * std::exp(-s)) / largest, exponent);
  unseen *= static_cast<double>(fit->values.size());
  double seen = 0.0;
  for (const double range : ranges) seen += std::pow(range / largest, exponent);
  return unseen / (unseen + seen);
}

}  // namespace brash::statistics
