// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>

#include "brash/statistics/events.hpp"
#include "brash/statistics/moments.hpp"

namespace brash::statistics {
namespace {

/// The longest run of samples at the peak of a load event.
struct FlatTop {
  double peak = -std::numeric_limits<double>::infinity();
  std::size_t samples = 0;
};

/// Adds the flat tops of one piece, of the events at its ends too.
void add_flat_tops(std::span<const double> piece, const EventLevels& levels, std::vector<FlatTop>& tops) {
  FlatTop top;
  std::size_t run = 0;  // of samples at the peak so far, up to this one
  const auto close = [&] {
    if (top.peak > levels.upper) tops.push_back(top);
    top = {};
  };
  for (const double value : piece) {
    if (value < levels.lower || (value == levels.lower && levels.lower == levels.level)) {
      close();
      continue;
    }
    if (value > top.peak) {
      top = {value, 0};
      run = 0;
    }
    run = value == top.peak ? run + 1 : 0;
    top.samples = std::max(top.samples, run);
  }
  close();
}

/// Median flat top of the events below the largest value; one sample where all reach it.
std::size_t median_of_lower(const std::vector<FlatTop>& tops, double largest) {
  std::vector<std::size_t> lower;
  for (const FlatTop& top : tops)
    if (top.peak < largest) lower.push_back(top.samples);
  if (lower.empty()) return 1;
  const auto middle = lower.begin() + static_cast<std::ptrdiff_t>(lower.size() / 2);
  std::ranges::nth_element(lower, middle);
  return *middle;
}

}  // namespace

std::optional<Clipping> clipping(const History& history, const EvenHistory& even) {
  const auto [low, high] = std::ranges::minmax(history.values);
  if (low == high || high == 0.0) return std::nullopt;
  const EventLevels levels = event_levels(history, even, moments(history.values, even.weights).mean);
  std::vector<FlatTop> tops;
  for (const auto piece : raw_pieces(history, even)) add_flat_tops(piece, levels, tops);
  constexpr std::size_t kLongTop = 5, kShortTop = 2;              // samples of an exact value
  constexpr std::size_t kLongInMedians = 3, kShortInMedians = 2;  // rounding alone seldom makes such tops
  const std::size_t median = median_of_lower(tops, high);
  std::size_t longest = 0, n_short = 0;
  for (const FlatTop& top : tops) {
    if (top.peak < high) continue;
    longest = std::max(longest, top.samples);
    n_short += top.samples >= std::max(kShortTop, kShortInMedians * median) ? 1 : 0;
  }
  if (longest < std::max(kLongTop, kLongInMedians * median) && n_short < 2) return std::nullopt;
  return Clipping{high, static_cast<std::size_t>(std::ranges::count(history.values, high))};
}

}  // namespace brash::statistics
