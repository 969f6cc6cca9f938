// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_statistics.hpp"

#include <algorithm>
#include <functional>
#include <iterator>

#include "brash/statistics/extreme_analysis.hpp"
#include "brash/statistics/peaks.hpp"
#include "brash/statistics/spectrum.hpp"

namespace brash::report {
namespace {

using nlohmann::ordered_json;

/// Segments an eighth of the history, so that about 15 are averaged.
ordered_json spectrum_of(const std::vector<double>& samples, double dt) {
  const std::size_t segment = samples.size() / 8;
  if (segment < 16) return nullptr;
  const statistics::Spectrum spectrum = statistics::welch_spectrum(samples, dt, segment);
  const statistics::Interval factors = statistics::spectrum_factors(spectrum);
  return {{"frequency", spectrum.frequency},
          {"density", spectrum.density},
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

}  // namespace

ordered_json load_statistics(const std::vector<model::LoadRow>& loads, double from, double until) {
  constexpr double kRounding = 1e-9;  // of a time, as a share
  const auto first = std::ranges::upper_bound(loads, from, {}, &model::LoadRow::time);
  const auto end = std::ranges::upper_bound(first, loads.end(), until * (1.0 + kRounding), {}, &model::LoadRow::time);
  if (end - first < 2) return nullptr;
  const double dt = (std::prev(end)->time - first->time) / static_cast<double>(end - first - 1);
  ordered_json out;
  const auto add = [&](const char* name, Vec3 Wrench::*part, double Vec3::*axis) {
    std::vector<double> samples;
    for (auto row = first; row != end; ++row) samples.push_back(row->total.*part.*axis);
    out[name] = {{"spectrum", spectrum_of(samples, dt)}, {"peaks", peaks_of(samples, first->time, dt)}};
  };
  add("Fx", &Wrench::force, &Vec3::x);
  add("Fy", &Wrench::force, &Vec3::y);
  add("Fz", &Wrench::force, &Vec3::z);
  add("Mx", &Wrench::moment, &Vec3::x);
  add("My", &Wrench::moment, &Vec3::y);
  add("Mz", &Wrench::moment, &Vec3::z);
  return out;
}

}  // namespace brash::report
