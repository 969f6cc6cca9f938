// SPDX-License-Identifier: GPL-3.0-or-later
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "brash/core/contract.hpp"
#include "brash/statistics/extreme_analysis.hpp"
#include "brash/statistics/moments.hpp"
#include "brash/statistics/peaks.hpp"

namespace brash::statistics {
namespace {

constexpr double kBlockInMemories = 20.0;  // autocorrelation times in a block
constexpr double kBlockInCycles = 5.0;     // fewest load cycles in a block
constexpr std::size_t kMostOver = 40;      // peaks over the threshold of a short record
constexpr double kShareOver = 0.1;         // of the peaks of a long record

/// Mean and deviation of all records, each sample with its time.
struct Level {
  double mean = 0.0, deviation = 0.0;
};

Level level_of(const std::vector<ExtremeRecord>& records) {
  double time = 0.0, sum = 0.0, squares = 0.0;
  for (const ExtremeRecord& record : records) {
    const Moments m = moments(record.history->values, record.even->weights);
    time += record.even->duration;
    sum += record.even->duration * m.mean;
    squares += record.even->duration * (m.variance + m.mean * m.mean);
  }
  const double mean = sum / time;
  return {mean, std::sqrt(std::max(0.0, squares / time - mean * mean))};
}

/// The value that `n` of the peaks are above.
double threshold_of(std::vector<double> peaks) {
  const std::size_t n = peaks.size();
  if (n == 0) return 0.0;
  const auto tenth = static_cast<std::size_t>(kShareOver * static_cast<double>(n));
  const std::size_t over = std::max(tenth, std::min(n / 2, kMostOver));
  const auto at = peaks.begin() + static_cast<std::ptrdiff_t>(n - over - (over < n ? 1 : 0));
  std::ranges::nth_element(peaks, at);
  return *at;
}

/// Maxima and damages of stretches as long are about independent.
double shortest_block(const ExtremeValues& values, double memory) {
  return std::max(kBlockInMemories * memory, std::isfinite(values.cycle) ? kBlockInCycles * values.cycle : 0.0);
}

/// Blocks grow with the record, so that their maxima come nearer to the laws of extremes as their number grows.
double default_block(const ExtremeValues& values) {
  if (!std::isfinite(values.cycle)) return values.shortest_block;
  const double growing = 0.25 * std::pow(static_cast<double>(values.n_events), 2.0 / 3.0);
  return std::max(values.shortest_block, growing * values.cycle);
}

/// Peaks of events over the threshold; the largest of those that follow each other within `separation`.
void add_over(const std::vector<LoadEvent>& events, ExtremeValues& values) {
  double last = 0.0;
  bool any = false;
  for (const LoadEvent& event : events) {
    if (event.peak <= values.threshold) continue;
    if (any && event.peak_time - last < values.separation)
      values.over.back() = std::max(values.over.back(), event.peak);
    else
      values.over.push_back(event.peak);
    any = true;
    last = event.peak_time;
  }
  std::size_t earlier = 0;
  for (const std::size_t n : values.over_of) earlier += n;
  values.over_of.push_back(values.over.size() - earlier);
}

/// Largest value of each whole block of an uneven piece. As in an even one, its last sample represents a step.
void add_maxima_by_time(std::span<const double> times, std::span<const double> piece, double step,
                        ExtremeValues& values) {
  constexpr double kRounding = 1e-6;  // of a step
  const double covered = times.back() - times.front() + (1.0 + kRounding) * step;
  std::vector<double> maxima(static_cast<std::size_t>(covered / values.block), -INFINITY);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto block = static_cast<std::size_t>((times[i] - times.front()) / values.block);
    if (block < maxima.size()) maxima[block] = std::max(maxima[block], piece[i]);
  }
  // A block shorter than an interval may hold no sample.
  for (const double maximum : maxima)
    if (std::isfinite(maximum)) values.maxima.push_back(maximum);
}

void add_maxima(const ExtremeRecord& record, ExtremeValues& values) {
  const EvenHistory& even = *record.even;
  const double step = even.sampling.step;
  const auto block = static_cast<std::size_t>(std::max(1.0, std::round(values.block / step)));
  const Pieces pieces = raw_pieces(*record.history, even);
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    if (!even.sampling.even) {
      add_maxima_by_time(std::span(record.history->times).subspan(even.cuts[p], pieces[p].size()), pieces[p], step,
                         values);
      continue;
    }
    for (const double maximum : block_maxima(pieces[p], block)) values.maxima.push_back(maximum);
  }
}

/// Correlation of the peaks of successive events, 0 for fewer than three pairs.
double correlation(const std::vector<std::vector<LoadEvent>>& events) {
  std::vector<double> first, second;
  for (const auto& record : events)
    for (std::size_t i = 1; i < record.size(); ++i) {
      first.push_back(record[i - 1].peak);
      second.push_back(record[i].peak);
    }
  if (first.size() < 3) return 0.0;
  const double r = gsl_stats_correlation(first.data(), 1, second.data(), 1, first.size());
  return std::isfinite(r) ? r : 0.0;
}

void note_clipping(const ExtremeRecord& record, ExtremeValues& values) {
  const auto found = record.clipping ? record.clipping : clipping(*record.history, *record.even);
  if (found && (!values.clipping || found->value > values.clipping->value)) values.clipping = found;
}

}  // namespace

bool acts_downwards(double mean, double minimum, double maximum) { return mean < 0.0 && -minimum > std::abs(maximum); }

ExtremeValues extreme_values(const std::vector<ExtremeRecord>& records, const ExtremeSettings& settings) {
  BRASH_EXPECTS(!records.empty());
  const Level level = level_of(records);
  ExtremeValues values;
  values.mean = level.mean;
  double memory = 0.0, minimum = INFINITY, maximum = -INFINITY;
  std::vector<std::vector<LoadEvent>> events;
  for (const ExtremeRecord& record : records) {
    const std::optional<double> band =
        settings.dead_band ? std::optional(*settings.dead_band * level.deviation) : std::nullopt;
    const EventLevels levels = event_levels(*record.history, *record.even, level.mean, band);
    events.push_back(load_events(*record.history, *record.even, levels));
    values.dead_band = std::max(values.dead_band, levels.upper - levels.lower);
    values.n_events += events.back().size();
    values.duration += record.even->duration;
    memory = std::max(memory, record.autocorrelation_time);
    for (const LoadEvent& event : events.back()) values.peaks.push_back(event.peak);
    note_clipping(record, values);
    const auto [low, high] = std::ranges::minmax(record.history->values);
    minimum = std::min(minimum, low);
    maximum = std::max(maximum, high);
  }
  values.acts_downwards = acts_downwards(level.mean, minimum, maximum);
  values.cycle = values.n_events < 2 ? INFINITY : values.duration / static_cast<double>(values.n_events);
  values.separation = 2.0 * memory;
  values.threshold = settings.threshold.value_or(threshold_of(values.peaks));
  values.shortest_block = settings.block > 0.0 ? settings.block : shortest_block(values, memory);
  values.block = settings.block > 0.0 ? settings.block : default_block(values);
  for (std::size_t i = 0; i < records.size(); ++i) {
    add_over(events[i], values);
    add_maxima(records[i], values);
  }
  values.correlation_of_peaks = correlation(events);
  return values;
}

}  // namespace brash::statistics
