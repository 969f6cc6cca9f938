// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "brash/statistics/events.hpp"
#include "brash/statistics/history.hpp"
#include "brash/statistics/moments.hpp"

namespace brash::statistics {
namespace {

constexpr double kStretchInCycles = 5.0;      // shorter stretches leave too much of the cycles in the averages
constexpr std::size_t kFewestStretches = 20;  // fewer give no autocorrelation time
constexpr double kInErrors = 2.0;             // of the averages' time: less would take chance for a slow change

/// Averages over whole stretches of `length` samples, piece by piece.
std::vector<std::vector<double>> averages(const Pieces& pieces, std::size_t length) {
  std::vector<std::vector<double>> all;
  for (const auto piece : pieces) {
    std::vector<double> of_piece;
    for (std::size_t first = 0; first + length <= piece.size(); first += length) {
      double sum = 0.0;
      for (const double value : piece.subspan(first, length)) sum += value;
      of_piece.push_back(sum / static_cast<double>(length));
    }
    if (!of_piece.empty()) all.push_back(std::move(of_piece));
  }
  return all;
}

std::size_t total(const std::vector<std::vector<double>>& pieces) {
  std::size_t n = 0;
  for (const std::vector<double>& piece : pieces) n += piece.size();
  return n;
}

double variance(const std::vector<std::vector<double>>& pieces) {
  std::vector<double> all;
  for (const std::vector<double>& piece : pieces) all.insert(all.end(), piece.begin(), piece.end());
  return moments(all).variance;
}

}  // namespace

AutocorrelationTime autocorrelation_time(const History& history, const EvenHistory& even) {
  const Pieces pieces = even.pieces(history);
  const double step = even.sampling.step;
  const AutocorrelationTime of_samples = autocorrelation_time(pieces, step);
  const Moments m = moments(history.values, even.weights);
  const double cycle = load_cycle(load_events(history, even, event_levels(history, even, m.mean)), even.duration);
  const double length = std::max(1.0, std::round(kStretchInCycles * cycle / step));
  if (!(length * static_cast<double>(kFewestStretches) <= static_cast<double>(history.values.size())))
    return of_samples;
  const auto means = averages(pieces, static_cast<std::size_t>(length));
  if (means.empty() || std::ranges::max(means, {}, &std::vector<double>::size).size() < kFewestStretches)
    return of_samples;
  AutocorrelationTime slow = autocorrelation_time(Pieces{means.begin(), means.end()}, length * step);
  const double error =
      std::sqrt(2.0 * (2.0 * static_cast<double>(slow.window) + 1.0) / static_cast<double>(total(means)));
  slow.tau *= variance(means) / m.variance;
  slow.window *= static_cast<std::size_t>(length);
  return slow.tau > (1.0 + kInErrors * error) * of_samples.tau ? slow : of_samples;
}

}  // namespace brash::statistics
