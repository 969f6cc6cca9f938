// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/rainflow.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

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

/// The ranges of whole cycles and the largest ranges.
struct RangeTail {
  std::vector<double> ranges;  ///< sorted, without the small ones, such as of noise
  double threshold = 0.0;
  std::size_t n_over = 0;

  /// The ranges above the threshold.
  std::span<const double> over() const { return std::span(ranges).last(n_over); }
  std::span<const double> below() const { return std::span(ranges).first(ranges.size() - n_over); }
};

/// Two halves with successive ranges are one cycle. Nothing when there are too few cycles for a law of their tail.
std::optional<RangeTail> tail_of(std::span<const Cycle> cycles) {
  if (cycles.empty()) return std::nullopt;
  const double largest = std::ranges::max(cycles, {}, &Cycle::range).range;
  std::vector<std::pair<double, double>> sorted;  // range and count
  for (const Cycle& c : cycles)
    if (c.range > kSmall * largest) sorted.emplace_back(c.range, c.count);
  std::ranges::sort(sorted);
  RangeTail tail;
  double counted = 0.0;
  for (const auto& [range, count] : sorted)
    for (counted += count; counted >= 1.0; counted -= 1.0) tail.ranges.push_back(range);
  const std::size_t n = tail.ranges.size();
  tail.n_over = std::min(n / 2, std::max(n / 10, kMostInTail));
  if (tail.n_over < kFewestInTail) return std::nullopt;
  tail.threshold = tail.below().back();
  return tail;
}

Distribution exponential(double threshold, double scale) { return {Law::kPareto, threshold, scale, 0.0}; }

double mean_excess(const RangeTail& tail) {
  double sum = 0.0;
  for (const double range : tail.over()) sum += range - tail.threshold;
  return sum / static_cast<double>(tail.n_over);
}

/// Likelihood ratio test of Pareto's law against an exponential tail.
bool heavier_than_exponential(const RangeTail& tail, double confidence) {
  const auto fit = fit_law(Law::kPareto, tail.over(), tail.threshold);
  if (!fit || fit->distribution.shape <= 0.0) return false;
  const Distribution light = exponential(tail.threshold, mean_excess(tail));
  double ratio = 0.0;
  for (const double range : fit->values)
    ratio += 2.0 * (fit->distribution.log_density(range) - light.log_density(range));
  return ratio > gsl_cdf_chisq_Pinv(confidence, 1.0);
}

/// Sum of (range/unit)^exponent.
double damage_of(std::span<const double> ranges, double exponent, double unit) {
  double sum = 0.0;
  for (const double range : ranges) sum += std::pow(range / unit, exponent);
  return sum;
}

/// Expected (range/unit)^exponent of a value of the law, of the values that are exceeded with less than `probability`.
double tail_damage(const Distribution& tail, double probability, double exponent, double unit) {
  constexpr double kStep = 0.05, kFarthest = 60.0;  // of the logarithm of the probability
  double sum = 0.0;
  for (double s = 0.5 * kStep; s < kFarthest && probability > 0.0; s += kStep)
    sum += kStep * probability * std::exp(-s) * std::pow(tail.level(probability * std::exp(-s)) / unit, exponent);
  return sum;
}

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
  const std::optional<RangeTail> tail = tail_of(cycles);
  if (!tail) return 1.0;
  const auto fit = fit_law(Law::kPareto, tail->over(), tail->threshold);
  if (!fit) return 0.0;
  // The end of a tail is seldom known: an exponential one is on the safe side.
  const Distribution law =
      fit->distribution.shape < 0.0 ? exponential(tail->threshold, mean_excess(*tail)) : fit->distribution;
  if (law.shape * exponent >= 1.0) return 1.0;
  const double largest = tail->ranges.back();
  const double unseen =
      static_cast<double>(tail->n_over) * tail_damage(law, law.exceedance(largest), exponent, largest);
  return unseen / (unseen + damage_of(tail->ranges, exponent, largest));
}

double largest_damage_ratio(std::span<const Cycle> cycles, double exponent, double confidence) {
  BRASH_EXPECTS(exponent >= 1.0 && confidence > 0.0 && confidence < 1.0, exponent, confidence);
  constexpr double kNoEnd = std::numeric_limits<double>::infinity();
  const std::optional<RangeTail> tail = tail_of(cycles);
  if (!tail || heavier_than_exponential(*tail, confidence)) return kNoEnd;
  // Twice the sum of n exponential excesses over their scale follows chi squared with 2n degrees of freedom.
  const auto n = static_cast<double>(tail->n_over);
  const double scale = mean_excess(*tail), rare = 0.5 - 0.5 * confidence;
  const double largest_scale = scale * 2.0 * n / gsl_cdf_chisq_Pinv(rare, 2.0 * n), unit = tail->ranges.back();
  const auto of_scale = [&](double s) { return tail_damage(exponential(tail->threshold, s), 1.0, exponent, unit); };
  const double by_scale = std::log(of_scale(largest_scale) / of_scale(scale));
  const double by_number = gsl_cdf_ugaussian_Qinv(rare) / std::sqrt(n);
  const double above = n * of_scale(scale) * std::exp(std::hypot(by_scale, by_number));
  return (damage_of(tail->below(), exponent, unit) + above) / damage_of(tail->ranges, exponent, unit);
}

}  // namespace brash::statistics
