// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/history.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "brash/core/contract.hpp"
#include "brash/statistics/quantile.hpp"
#include "samples.hpp"
#include "weighted_summary.hpp"

namespace brash::statistics {
namespace {

constexpr double kGapInSteps = 5.0;     // of the median interval
constexpr double kEvenTolerance = 0.1;  // of a step: the rounding of printed times

std::vector<double> intervals_of(const std::vector<double>& times) {
  std::vector<double> intervals(times.size() - 1);
  for (std::size_t i = 1; i < times.size(); ++i) {
    intervals[i - 1] = times[i] - times[i - 1];
    BRASH_EXPECTS(intervals[i - 1] > 0.0, i, times[i]);
  }
  return intervals;
}

double median(std::vector<double> values) {
  const std::array<double, 1> half{0.5};
  return quantiles(std::move(values), half)[0];
}

/// Finds gaps and the statistics of the other intervals; fills cuts and sampling but for `even`.
void cut(const History& history, const std::vector<double>& intervals, double longest_interval, EvenHistory& even) {
  Sampling& sampling = even.sampling;
  sampling.shortest = *std::ranges::max_element(intervals);
  even.cuts = {0};
  double covered = 0.0;
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    if (intervals[i] > longest_interval) {
      sampling.gaps.push_back({history.times[i], history.times[i + 1]});
      even.cuts.push_back(i + 1);
      continue;
    }
    covered += intervals[i];
    sampling.shortest = std::min(sampling.shortest, intervals[i]);
    sampling.longest = std::max(sampling.longest, intervals[i]);
  }
  even.cuts.push_back(history.times.size());
  sampling.step = covered / static_cast<double>(intervals.size() - sampling.gaps.size());
}

/// Largest distance of a piece's times from an even grid through its first and last one [s].
double distance_from_grid(std::span<const double> times) {
  const double step = (times.back() - times.front()) / static_cast<double>(std::max<std::size_t>(1, times.size() - 1));
  double largest = 0.0;
  for (std::size_t i = 0; i < times.size(); ++i)
    largest = std::max(largest, std::abs(times[i] - times.front() - step * static_cast<double>(i)));
  return largest;
}

std::vector<double> weights_of(const std::vector<double>& intervals, double longest_interval, double step) {
  const auto half = [&](double interval) { return 0.5 * (interval > longest_interval ? step : interval); };
  std::vector<double> weights(intervals.size() + 1, 0.5 * step);
  weights.front() += half(intervals.front());
  weights.back() += half(intervals.back());
  for (std::size_t i = 1; i < intervals.size(); ++i) weights[i] = half(intervals[i - 1]) + half(intervals[i]);
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

Pieces EvenHistory::views() const { return {pieces.begin(), pieces.end()}; }

Pieces raw_pieces(const History& history, const EvenHistory& even) {
  Pieces pieces;
  for (std::size_t p = 0; p + 1 < even.cuts.size(); ++p) pieces.push_back(piece(history.values, even, p));
  return pieces;
}

EvenHistory make_even(const History& history, double longest_interval) {
  BRASH_EXPECTS(history.times.size() >= 2 && history.times.size() == history.values.size(), history.times.size());
  BRASH_EXPECTS(all_finite(history.times) && all_finite(history.values));
  BRASH_EXPECTS(longest_interval >= 0.0, longest_interval);
  const std::vector<double> intervals = intervals_of(history.times);
  if (longest_interval == 0.0) longest_interval = kGapInSteps * median(intervals);
  // A shortest interval beyond the limit leaves nothing to take a step from.
  longest_interval = std::max(longest_interval, *std::ranges::min_element(intervals));

  EvenHistory even;
  cut(history, intervals, longest_interval, even);
  const double step = even.sampling.step;
  for (std::size_t p = 0; p + 1 < even.cuts.size(); ++p)
    even.sampling.even =
        even.sampling.even && distance_from_grid(piece(history.times, even, p)) <= kEvenTolerance * step;
  for (std::size_t p = 0; p + 1 < even.cuts.size(); ++p) {
    const auto times = piece(history.times, even, p), values = piece(history.values, even, p);
    even.pieces.push_back(even.sampling.even ? std::vector<double>(values.begin(), values.end())
                                             : resample(times, values, step));
  }
  even.weights = even.sampling.even ? std::vector<double>(history.times.size(), step)
                                    : weights_of(intervals, longest_interval, step);
  for (const double weight : even.weights) even.duration += weight;
  return even;
}

Summary summarise(const History& history, const EvenHistory& even) {
  return summarise_weighted(history.values, even.weights, autocorrelation_time(even.views(), even.sampling.step));
}

}  // namespace brash::statistics
