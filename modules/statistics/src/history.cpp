// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "brash/core/contract.hpp"
#include "brash/statistics/quantile.hpp"
#include "samples.hpp"

namespace brash::statistics {
namespace {

constexpr double kGapInSteps = 5.0;     // of the median interval
constexpr double kMostInGaps = 0.1;     // of the time span: a change of the sampling rate looks like many gaps
constexpr double kEvenTolerance = 0.1;  // of a step: the rounding of printed times

double median_interval(const std::vector<double>& times) {
  std::vector<double> intervals(times.size() - 1);
  for (std::size_t i = 1; i < times.size(); ++i) intervals[i - 1] = times[i] - times[i - 1];
  return quantiles(std::move(intervals), std::array{0.5})[0];
}

double shortest_interval(const std::vector<double>& times) {
  double shortest = times[1] - times[0];
  for (std::size_t i = 1; i < times.size(); ++i) {
    BRASH_EXPECTS(times[i] > times[i - 1], i, times[i]);
    shortest = std::min(shortest, times[i] - times[i - 1]);
  }
  return shortest;
}

/// Finds gaps and the statistics of the other intervals; fills cuts and sampling but for `even`.
void cut(const std::vector<double>& times, double longest_interval, EvenHistory& even) {
  Sampling& sampling = even.sampling;
  even.cuts = {0};
  double covered = 0.0;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const double interval = times[i + 1] - times[i];
    if (interval > longest_interval) {
      sampling.gaps.push_back({times[i], times[i + 1]});
      even.cuts.push_back(i + 1);
      continue;
    }
    covered += interval;
    sampling.longest = std::max(sampling.longest, interval);
  }
  even.cuts.push_back(times.size());
  sampling.step = covered / static_cast<double>(times.size() - 1 - sampling.gaps.size());
}

/// Largest distance of a piece's times from an even grid of `step` from its first one on [s].
double distance_from_grid(std::span<const double> times, double step) {
  double largest = 0.0;
  for (std::size_t i = 0; i < times.size(); ++i)
    largest = std::max(largest, std::abs(times[i] - times.front() - step * static_cast<double>(i)));
  return largest;
}

/// Keeps the step of a history that was sampled evenly but lost a few samples: each interval is a whole number of
/// steps.
void keep_nominal_step(const std::vector<double>& times, double median, EvenHistory& even) {
  double covered = 0.0, steps = 0.0;
  std::vector<double> grid(times.size(), 0.0);  // steps since the first time of the piece
  std::size_t n_intervals = 0;
  for (std::size_t p = 0; p + 1 < even.cuts.size(); ++p)
    for (std::size_t i = even.cuts[p] + 1; i < even.cuts[p + 1]; ++i) {
      const double n = std::max(1.0, std::round((times[i] - times[i - 1]) / median));
      grid[i] = grid[i - 1] + n;
      covered += times[i] - times[i - 1];
      steps += n;
      ++n_intervals;
    }
  const double step = covered / steps, lost = steps - static_cast<double>(n_intervals);
  if (lost > kMostInGaps * steps) return;
  for (std::size_t p = 0; p + 1 < even.cuts.size(); ++p)
    for (std::size_t i = even.cuts[p]; i < even.cuts[p + 1]; ++i)
      if (std::abs(times[i] - times[even.cuts[p]] - step * grid[i]) > kEvenTolerance * step) return;
  even.sampling.n_lost = static_cast<std::size_t>(lost);
  if (even.sampling.n_lost > 0) even.sampling.step = step;
}

/// Pieces of one sample, which show nothing about a grid.
std::size_t n_single(const EvenHistory& even) {
  std::size_t n = 0;
  for (std::size_t p = 0; p + 1 < even.cuts.size(); ++p) n += even.cuts[p + 1] == even.cuts[p] + 1 ? 1 : 0;
  return n;
}

bool is_mostly_single(const EvenHistory& even) { return 2 * n_single(even) > even.cuts.size() - 1; }

std::vector<double> weights_of(const std::vector<double>& times, double longest_interval, double step) {
  const auto half_before = [&](std::size_t i) {
    const double interval = times[i] - times[i - 1];
    return 0.5 * (interval > longest_interval ? step : interval);
  };
  std::vector<double> weights(times.size(), 0.5 * step);
  weights.front() += half_before(1);
  weights.back() += half_before(times.size() - 1);
  for (std::size_t i = 1; i + 1 < times.size(); ++i) weights[i] = half_before(i) + half_before(i + 1);
  return weights;
}

/// Values every `step` from the first time on, interpolated linearly.
std::vector<double> resample(std::span<const double> times, std::span<const double> values, double step) {
  // A thousandth absorbs the rounding of a last sample that lies on the grid.
  const auto n = static_cast<std::size_t>((times.back() - times.front()) / step + 1e-3) + 1;
  std::vector<double> resampled(n, values.front());
  std::size_t next = 1;  // first time beyond t
  for (std::size_t i = 1; i < n; ++i) {
    const double t = std::min(times.front() + step * static_cast<double>(i), times.back());
    while (next + 1 < times.size() && times[next] < t) ++next;
    const double share = (t - times[next - 1]) / (times[next] - times[next - 1]);
    resampled[i] = values[next - 1] + share * (values[next] - values[next - 1]);
  }
  return resampled;
}

std::span<const double> piece(const std::vector<double>& column, const EvenHistory& even, std::size_t index) {
  return std::span(column).subspan(even.cuts[index], even.cuts[index + 1] - even.cuts[index]);
}

}  // namespace

Pieces EvenHistory::pieces(const History& history) const {
  return sampling.even ? raw_pieces(history, *this) : Pieces{resampled.begin(), resampled.end()};
}

Pieces raw_pieces(const History& history, const EvenHistory& even) {
  Pieces pieces;
  for (std::size_t p = 0; p + 1 < even.cuts.size(); ++p) pieces.push_back(piece(history.values, even, p));
  return pieces;
}

EvenHistory make_even(const History& history, double longest_interval) {
  BRASH_EXPECTS(history.times.size() >= 2 && history.times.size() == history.values.size(), history.times.size());
  BRASH_EXPECTS(all_finite(history.times) && all_finite(history.values));
  BRASH_EXPECTS(longest_interval >= 0.0, longest_interval);
  EvenHistory even;
  even.sampling.shortest = shortest_interval(history.times);
  const double median = median_interval(history.times);
  if (longest_interval == 0.0) longest_interval = kGapInSteps * median;
  // A shortest interval beyond the limit leaves nothing to take a step from.
  longest_interval = std::max(longest_interval, even.sampling.shortest);
  cut(history.times, longest_interval, even);
  keep_nominal_step(history.times, median, even);
  const double step = even.sampling.step;
  even.sampling.even = !is_mostly_single(even);
  for (std::size_t p = 0; p + 1 < even.cuts.size(); ++p)
    even.sampling.even =
        even.sampling.even && distance_from_grid(piece(history.times, even, p), step) <= kEvenTolerance * step;
  for (std::size_t p = 0; p + 1 < even.cuts.size() && !even.sampling.even; ++p)
    even.resampled.push_back(resample(piece(history.times, even, p), piece(history.values, even, p), step));
  even.weights = even.sampling.even ? std::vector{step} : weights_of(history.times, longest_interval, step);
  for (std::size_t i = 0; i < history.times.size(); ++i) even.duration += even.weight(i);
  return even;
}

std::string gap_warning(const History& history, const EvenHistory& even) {
  if (is_mostly_single(even))
    return fmt::format("{} of {} pieces between gaps have one sample: the sampling rate seems to change, so give --gap",
                       n_single(even), even.cuts.size() - 1);
  double unknown = 0.0;
  for (const Gap& gap : even.sampling.gaps) unknown += gap.to - gap.from;
  const double share = unknown / (history.times.back() - history.times.front());
  if (share <= kMostInGaps) return "";
  return fmt::format("gaps cover {:.0f} % of the time: if the sampling rate changes, give --gap", 100.0 * share);
}

Summary summarise(const History& history, const EvenHistory& even) {
  return summarise_weighted(history.values, even.weights, autocorrelation_time(history, even));
}

}  // namespace brash::statistics
