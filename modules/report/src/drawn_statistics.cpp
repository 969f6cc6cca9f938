// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "long_history.hpp"

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
  if (n > 0) chosen.push_back(n);
  return chosen;
}

/// The lines to draw: of many, the lowest and the highest of each band, bands evenly by the logarithm of the frequency.
std::vector<std::size_t> drawn_lines(const std::vector<double>& density) {
  std::vector<std::size_t> lines{0};
  std::size_t first = 1;
  for (const std::size_t last : spread(density.size() - 1)) {
    const auto begin = density.begin();
    const auto [low, high] =
        std::minmax_element(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last) + 1);
    const auto [a, b] = std::minmax({low - begin, high - begin});
    lines.push_back(static_cast<std::size_t>(a));
    if (b != a) lines.push_back(static_cast<std::size_t>(b));
    first = last + 1;
  }
  return lines;
}

void thin(ordered_json& spectrum) {
  if (spectrum.is_null()) return;
  const auto density = spectrum.at("density").get<std::vector<double>>();
  ordered_json frequencies = ordered_json::array(), densities = ordered_json::array();
  for (const std::size_t line : drawn_lines(density)) {
    frequencies.push_back(spectrum.at("frequency")[line]);
    densities.push_back(spectrum.at("density")[line]);
  }
  spectrum["frequency"] = std::move(frequencies);
  spectrum["density"] = std::move(densities);
  spectrum["n_lines"] = density.size();
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

ordered_json drawn_statistics(ordered_json statistics, const LoadSamples& samples, double from, double until,
                              Blocks& blocks) {
  if (statistics.is_null()) return statistics;
  constexpr double kRounding = 1e-9;  // of a time, as a share
  const auto& times = samples.times;
  const auto first = std::ranges::upper_bound(times, from) - times.begin();
  const auto end = std::upper_bound(times.begin() + first, times.end(), until * (1.0 + kRounding)) - times.begin();
  for (std::size_t i = 0; i < kLoadNames.size(); ++i) {
    ordered_json& of_load = statistics.at(kLoadNames[i]);
    thin(of_load.at("spectrum"));
    const auto begin = samples.loads[i].begin();
    add_exceedance(blocks, kLoadNames[i], {begin + first, begin + end}, of_load.at("lower_end").get<bool>());
  }
  return statistics;
}

}  // namespace brash::report
