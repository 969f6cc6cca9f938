// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "brash/analysis/history_statistics.hpp"
#include "brash/statistics/intervals.hpp"
#include "brash/statistics/moments.hpp"
#include "brash/statistics/spectrum.hpp"
#include "studies.hpp"

namespace brash::coverage {
namespace {

using namespace statistics;

constexpr int kCycles = 100;
constexpr double kSegment = 12.5;   // of the spectrum [s]: an eighth of a record
constexpr int kResamples = 200;     // fewer than a user takes: the ends are a little less certain
constexpr double kBlockTimes = 10;  // autocorrelation times in a block, as in the tutorial

/// Type 7 of Hyndman and Fan, without sorting all.
double quantile(std::span<const double> samples, double level) {
  std::vector<double> values(samples.begin(), samples.end());
  const double place = level * static_cast<double>(values.size() - 1);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(place);
  std::ranges::nth_element(values, at);
  const double next = *std::min_element(at + 1, values.end());
  return *at + (place - std::floor(place)) * (next - *at);
}

/// The Python module's bootstrap of a statistic of one history.
void study_statistic(const Process& process, const char* name, double truth, int records, Table& table,
                     const std::function<double(std::span<const double>)>& statistic) {
  for (int r = 0; r < records; ++r) {
    RandomStream stream(1, process.name, static_cast<std::uint64_t>(r), name);
    const analysis::LoadHistory load = record(process, kCycles, stream);
    const Summary s = summarise(load.history, load.even);
    BootstrapSettings settings;
    settings.n_resamples = kResamples;
    settings.block_length = static_cast<std::size_t>(
        std::max(1.0, std::round(kBlockTimes * s.autocorrelation_time / load.even.sampling.step)));
    table.add(process.name, name, bootstrap_interval(load.history.values, statistic, settings, stream), truth);
  }
}

}  // namespace

void study_history(const Process& process, int records, Table& table) {
  const double mean = mean_load(process);
  const Truth truth = truth_of(process, kSegment);
  for (int r = 0; r < records; ++r) {
    RandomStream stream(1, process.name, static_cast<std::uint64_t>(r), "history");
    const analysis::LoadHistory load = record(process, kCycles, stream);
    const Summary s = summarise(load.history, load.even);
    table.add(process.name, "mean", s.mean_95, mean);
    table.add(process.name, "mean by 20 batches", batch_means_interval(load.history.values, 20), mean);
    const Spectrum spectrum = analysis::spectrum_of(load, kSegment).value();
    const Interval factors = spectrum_factors(spectrum);
    for (std::size_t k = 1; k + 1 < spectrum.density.size(); ++k)
      table.add(process.name, "spectrum line",
                Interval{factors.lower * spectrum.density[k], factors.upper * spectrum.density[k]}, truth.spectrum[k]);
  }
}

void study_slow_change(const Process& process, int records, Table& table) {
  constexpr int kManyCycles = 1000;
  constexpr double kSlow = 0.2;  // deviation of the slow factor of the peaks
  const double mean = mean_load(process);
  for (int r = 0; r < records; ++r) {
    RandomStream stream(1, process.name, static_cast<std::uint64_t>(r), "slow change");
    const analysis::LoadHistory load = record(process, kManyCycles, stream, 1.0, kSlow);
    table.add(process.name, "mean under a slow change", summarise(load.history, load.even).mean_95, mean);
    table.add(process.name, "mean under a slow change by 20 batches", batch_means_interval(load.history.values, 20),
              mean);
  }
}

void study_bootstrap(const Process& process, int records, Table& table) {
  const Truth truth = truth_of(process, kSegment);
  const auto deviation = [](std::span<const double> x) { return std::sqrt(moments(x).variance); };
  study_statistic(process, "deviation by bootstrap", truth.deviation, records, table, deviation);
  const auto study_quantile = [&](const char* name, double level, double true_level) {
    study_statistic(process, name, true_level, records, table,
                    [level](std::span<const double> x) { return quantile(x, level); });
  };
  study_quantile("50 % load by bootstrap", 0.5, truth.quantile_50);
  study_quantile("95 % load by bootstrap", 0.95, truth.quantile_95);
  study_quantile("99 % load by bootstrap", 0.99, truth.quantile_99);
}

}  // namespace brash::coverage
