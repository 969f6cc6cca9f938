// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "brash/statistics/extreme_analysis.hpp"
#include "brash/statistics/peaks.hpp"
#include "brash/statistics/spectrum.hpp"

namespace brash::report {
namespace {

using nlohmann::ordered_json;

/// Points of a curve that a wide screen can tell apart.
constexpr std::size_t kDrawnPoints = 2000;

/// Whole numbers from 1 to `n`, all or about kDrawnPoints: the first ones all, then evenly by their logarithm; `n` too.
std::vector<std::size_t> spread(std::size_t n) {
  std::vector<std::size_t> chosen;
  const double ratio = std::pow(static_cast<double>(n), 1.0 / static_cast<double>(kDrawnPoints));
  for (std::size_t next = 1; next < n;) {
    chosen.push_back(next);
    next =
        n <= kDrawnPoints ? next + 1 : std::max(next + 1, static_cast<std::size_t>(static_cast<double>(next) * ratio));
  }
  chosen.push_back(n);
  return chosen;
}

/// The lines to draw: of many, the lowest and the highest of each band, bands evenly by the logarithm of the frequency.
std::vector<std::size_t> drawn_lines(const statistics::Spectrum& spectrum) {
  const std::size_t n = spectrum.frequency.size();
  std::vector<std::size_t> lines{0};
  std::size_t first = 1;
  for (const std::size_t last : spread(n - 1)) {
    const auto band = spectrum.density.begin();
    const auto [low, high] =
        std::minmax_element(band + static_cast<std::ptrdiff_t>(first), band + static_cast<std::ptrdiff_t>(last) + 1);
    const auto [a, b] = std::minmax({low - band, high - band});
    lines.push_back(static_cast<std::size_t>(a));
    if (b != a) lines.push_back(static_cast<std::size_t>(b));
    first = last + 1;
  }
  return lines;
}

/// Segments an eighth of the history, so that about 15 are averaged.
ordered_json spectrum_of(const std::vector<double>& samples, double dt) {
  const std::size_t segment = samples.size() / 8;
  if (segment < 16) return nullptr;
  const statistics::Spectrum spectrum = statistics::welch_spectrum(samples, dt, segment);
  const statistics::Interval factors = statistics::spectrum_factors(spectrum);
  ordered_json frequency = ordered_json::array(), density = ordered_json::array();
  for (const std::size_t line : drawn_lines(spectrum)) {
    frequency.push_back(spectrum.frequency[line]);
    density.push_back(spectrum.density[line]);
  }
  return {{"frequency", frequency},
          {"density", density},
          {"n_lines", spectrum.frequency.size()},
          {"factors_95", {factors.lower, factors.upper}},
          {"n_segments", spectrum.n_segments}};
}

/// The peaks of the end at which the load acts, the largest in size first.
ordered_json peaks_of(std::vector<double> samples, double start, double dt) {
  double sum = 0.0;
  for (const double sample : samples) sum += sample;
  const double mean = sum / static_cast<double>(samples.size());
  const auto [low, high] = std::ranges::minmax(samples);
  const bool downwards = statistics::acts_downwards(mean, low, high);
  const double sign = downwards ? -1.0 : 1.0;
  for (double& sample : samples) sample *= sign;
  std::vector<statistics::Peak> peaks = statistics::peaks_between_crossings(samples, sign * mean);
  std::ranges::stable_sort(peaks, std::greater<>{}, &statistics::Peak::value);
  ordered_json values = ordered_json::array(), times = ordered_json::array();
  for (const statistics::Peak& peak : peaks) {
    values.push_back(sign * peak.value);
    times.push_back(start + dt * static_cast<double>(peak.index));
  }
  return {{"value", values}, {"time", times}, {"lower_end", downwards}};
}

void add_exceedance(Blocks& blocks, const std::string& name, std::vector<double> load, bool lower_end) {
  std::ranges::sort(load);
  if (!lower_end) std::ranges::reverse(load);
  std::vector<double> values;
  std::vector<std::int32_t> ranks;
  for (const std::size_t rank : spread(load.size())) {
    values.push_back(load[rank - 1]);
    ranks.push_back(static_cast<std::int32_t>(rank));
  }
  blocks.add_single("exceedance." + name + ".value", values);
  blocks.add("exceedance." + name + ".rank", ranks);
}

}  // namespace

ordered_json load_statistics(const LoadSamples& samples, double from, double until, Blocks& blocks) {
  constexpr double kRounding = 1e-9;  // of a time, as a share
  const auto first = std::ranges::upper_bound(samples.times, from);
  const auto end = std::ranges::upper_bound(first, samples.times.end(), until * (1.0 + kRounding));
  if (end - first < 2) return nullptr;
  const double dt = (*std::prev(end) - *first) / static_cast<double>(end - first - 1);
  const std::ptrdiff_t start = first - samples.times.begin();
  ordered_json out;
  for (std::size_t i = 0; i < kLoadNames.size(); ++i) {
    const auto begin = samples.loads[i].begin() + start;
    std::vector<double> load(begin, begin + (end - first));
    const ordered_json peaks = peaks_of(load, *first, dt);
    out[kLoadNames[i]] = {{"spectrum", spectrum_of(load, dt)}, {"peaks", peaks}};
    add_exceedance(blocks, kLoadNames[i], std::move(load), peaks["lower_end"].get<bool>());
  }
  return out;
}

}  // namespace brash::report
