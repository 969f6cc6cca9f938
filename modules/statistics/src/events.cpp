// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/events.hpp"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "brash/core/contract.hpp"
#include "samples.hpp"

namespace brash::statistics {
namespace {

/// Median of |z|/sqrt(6) for second differences z of white noise of deviation 1: 0.6745.
constexpr double kMedianOfNoise = 0.674489750196082;

/// The time at which the straight line between two samples is at `level`.
double crossing(const History& h, std::size_t before, double level) {
  const double rise = h.values[before + 1] - h.values[before];
  const double share = rise == 0.0 ? 0.0 : (level - h.values[before]) / rise;
  return h.times[before] + share * (h.times[before + 1] - h.times[before]);
}

/// Integral of the load between two crossings of `level`, by trapezoids.
/// @param before, last  samples before the first and before the second crossing.
double impulse(const History& h, double level, std::size_t before, std::size_t last, double start, double end) {
  double sum = 0.5 * (level + h.values[before + 1]) * (h.times[before + 1] - start);
  for (std::size_t i = before + 1; i < last; ++i)
    sum += 0.5 * (h.values[i] + h.values[i + 1]) * (h.times[i + 1] - h.times[i]);
  return sum + 0.5 * (h.values[last] + level) * (end - h.times[last]);
}

/// The events of one piece, samples [first, last) of the history.
void add_events(const History& h, std::size_t first, std::size_t last, const EventLevels& levels,
                std::vector<LoadEvent>& events) {
  std::optional<std::size_t> up, down;  // samples before the newest crossings of the level
  bool inside = false;
  for (std::size_t i = first; i + 1 < last; ++i) {
    const double now = h.values[i], next = h.values[i + 1];
    if (now <= levels.level && next > levels.level && !inside) up = i;
    if (now > levels.level && next <= levels.level) down = i;
    if (!inside && up && next > levels.upper) inside = true;
    const bool over = next < levels.lower || (next == levels.lower && levels.lower == levels.level);
    if (!inside || !down || *down < *up || !over) continue;
    LoadEvent event;
    event.start = crossing(h, *up, levels.level);
    event.end = crossing(h, *down, levels.level);
    const auto begin = h.values.begin();
    const auto peak =
        std::max_element(begin + static_cast<std::ptrdiff_t>(*up) + 1, begin + static_cast<std::ptrdiff_t>(*down) + 1);
    event.peak_index = static_cast<std::size_t>(peak - begin);
    event.peak = *peak;
    event.peak_time = h.times[event.peak_index];
    event.impulse = impulse(h, levels.level, *up, *down, event.start, event.end);
    events.push_back(event);
    inside = false;
    up.reset();
  }
}

}  // namespace

double noise_floor(const Pieces& pieces) {
  std::size_t n = 0;
  for (const auto piece : pieces) n += piece.size();
  std::vector<double> sizes;
  sizes.reserve(n);  // growing would take twice the room
  for (const auto piece : pieces) {
    BRASH_EXPECTS(all_finite(piece));
    for (std::size_t i = 2; i < piece.size(); ++i)
      sizes.push_back(std::abs(piece[i] - 2.0 * piece[i - 1] + piece[i - 2]));
  }
  if (sizes.empty()) return 0.0;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::ranges::nth_element(sizes, middle);
  return *middle / (kMedianOfNoise * std::sqrt(6.0));
}

double noise_band(const History& history, const EvenHistory& even) {
  constexpr double kInNoise = 5.0;       // fewer deviations of the noise count noise, more miss events
  constexpr double kInDeviations = 3.0;  // of the load
  const double deviation = gsl_stats_sd(history.values.data(), 1, history.values.size());
  return std::min(kInNoise * noise_floor(even.pieces(history)), kInDeviations * deviation);
}

EventLevels event_levels(const History& history, const EvenHistory& even, double level,
                         std::optional<double> dead_band) {
  const double band = dead_band ? *dead_band : noise_band(history, even);
  BRASH_EXPECTS(band >= 0.0 && std::isfinite(level), band, level);
  double low = 0.0, high = 0.0;
  gsl_stats_minmax(&low, &high, history.values.data(), 1, history.values.size());
  return {level, std::min(level + 0.5 * band, std::max(level, 0.5 * (level + high))),
          std::max(level - 0.5 * band, std::min(level, 0.5 * (level + low)))};
}

std::vector<LoadEvent> load_events(const History& history, const EvenHistory& even, const EventLevels& levels) {
  BRASH_EXPECTS(levels.lower <= levels.level && levels.level <= levels.upper, levels.lower, levels.upper);
  std::vector<LoadEvent> events;
  for (std::size_t p = 0; p + 1 < even.cuts.size(); ++p)
    add_events(history, even.cuts[p], even.cuts[p + 1], levels, events);
  return events;
}

double load_cycle(const std::vector<LoadEvent>& events, double duration) {
  return events.size() < 2 ? std::numeric_limits<double>::infinity() : duration / static_cast<double>(events.size());
}

}  // namespace brash::statistics
