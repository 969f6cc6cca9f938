// SPDX-License-Identifier: GPL-3.0-or-later
// How often the 95 % intervals of load statistics hold the truth, on simulated sawtooth loads.
//
//   bench_coverage [RECORDS [CYCLES]]
//
// prints rows process,cycles,periods,interval,share,n: the share of n intervals that hold the truth. A load rises
// straight to a random peak and drops; cycles have a mean length of 1 s. `periods` is the return period in records.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "brash/statistics/extreme_analysis.hpp"
#include "brash/statistics/hypothesis.hpp"
#include "brash/statistics/intervals.hpp"
#include "brash/statistics/moments.hpp"
#include "brash/statistics/rainflow.hpp"
#include "brash/statistics/summary.hpp"

namespace {

using namespace brash::statistics;

constexpr double kStep = 0.05;      // [s]
constexpr double kResidual = 20.0;  // load after a drop

/// A distribution of peaks with its quantile function.
struct Process {
  std::string name;
  std::function<double(double)> peak;  ///< level that a peak exceeds with a probability
};

double normal_quantile(double q) {
  double low = -12.0, high = 12.0;  // of a deviation
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(middle / std::sqrt(2.0)) > q ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

std::vector<Process> processes() {
  return {{"uniform", [](double q) { return 300.0 - 200.0 * q; }},
          {"normal", [](double q) { return std::max(30.0, 200.0 + 40.0 * normal_quantile(q)); }},
          {"Rayleigh", [](double q) { return 40.0 + 80.0 * std::sqrt(-2.0 * std::log(q)); }},
          {"exponential", [](double q) { return 100.0 - 40.0 * std::log(q); }},
          {"Pareto 0.15", [](double q) { return 100.0 + 40.0 / 0.15 * (std::pow(q, -0.15) - 1.0); }}};
}

/// A record of sawtooth cycles that begins and ends within one.
History record(const Process& process, int cycles, RandomStream& stream) {
  History history;
  const auto add = [&](double value) {
    history.times.push_back(kStep * static_cast<double>(history.times.size()));
    history.values.push_back(value);
  };
  for (double time = 0.0; time < cycles;) {
    const double wanted = std::max(0.3, 1.0 + 0.3 * stream.normal());
    const int n = static_cast<int>(std::round(wanted / kStep));
    const double peak = process.peak(stream.uniform() + 0x1p-49);
    for (int i = 1; i <= n; ++i) add(kResidual + (peak - kResidual) * i / n);
    time += n * kStep;
  }
  return history;
}

/// Counts of intervals that hold the truth.
struct Tally {
  int held = 0, n = 0;
  void add(const Interval& interval, double truth) {
    ++n;
    held += interval.lower <= truth && truth <= interval.upper ? 1 : 0;
  }
};

/// Long-run damage a second and mean, from one long record.
struct Truth {
  double mean = 0.0;
  std::map<int, double> damage_rate;
};

constexpr std::array<int, 3> kExponents{3, 5, 10};

Truth long_run(const Process& process) {
  RandomStream stream(9, process.name, 0, "truth");
  const History history = record(process, 400'000, stream);
  Truth truth{moments(history.values).mean, {}};
  const auto cycles = rainflow(history.values);
  for (const int m : kExponents)
    truth.damage_rate[m] = damage(cycles, m) / (kStep * static_cast<double>(history.values.size()));
  return truth;
}

using Tallies = std::map<std::string, Tally>;

void count_extremes(const Process& process, const ExtremeValues& values, double periods, GoodnessOfFit& goodness,
                    Tallies& tallies) {
  ExtremeSettings settings;
  settings.return_period = periods * values.duration;
  const ExtremeAnalysis analysis = analyse_extremes(values, settings, goodness);
  const double truth = process.peak(1.0 / settings.return_period);  // one cycle a second
  for (const ExtremeEstimate& e : analysis.estimates) {
    const bool limited = e.fit && e.law == Law::kPareto && e.fit->distribution.shape <= -0.5;
    if (e.level) tallies[std::string(name_of(e.law)) + (limited ? " at its limit" : "")].add(e.level->interval, truth);
  }
  if (analysis.recommended) tallies["recommended"].add(analysis.of(*analysis.recommended).level->interval, truth);
}

void count_fatigue(const History& history, const Truth& truth, double stretch_time, RandomStream& stream,
                   Tallies& tallies) {
  const auto cycles = rainflow(history.values);
  const auto stretch = static_cast<std::size_t>(stretch_time / kStep);
  for (const int m : kExponents) {
    const StretchDamages stretches = damage_by_stretch(cycles, m, history.values.size(), stretch);
    if (stretches.damages.size() < 10) continue;
    const Interval interval = damage_rate_interval(stretches, 0.95, stream);
    const bool warned = unseen_damage(cycles, m) > kMostUnseen;
    tallies[fmt::format("equivalent load m={}{}", m, warned ? " with warning" : "")].add(
        {interval.lower / kStep, interval.upper / kStep}, truth.damage_rate.at(m));
  }
}

/// One record with the statistics that comparisons need.
struct Sample {
  History history;
  EvenHistory even;
  Summary load, squares;

  Sample(const Process& process, int cycles, RandomStream& stream)
      : history(record(process, cycles, stream)), even(make_even(history)), load(summarise(history, even)) {
    std::vector<double> squared = history.values;
    for (double& value : squared) value = (value - load.mean) * (value - load.mean);
    squares = summarise(squared, kStep);
  }
};

/// Two records of one process: their ratios are 1.
void count_comparisons(const Sample& a, const Sample& b, Tallies& tallies) {
  tallies["ratio of means"].add(compare_ratio(a.load, b.load).interval, 1.0);
  tallies["ratio of deviations"].add(compare_deviations(a.squares, b.squares).interval, 1.0);
}

void study(const Process& process, int cycles, int records) {
  const Truth truth = long_run(process);
  GoodnessOfFit goodness;
  std::map<double, Tallies> by_period;
  Tallies others;
  for (int r = 0; r < records; ++r) {
    RandomStream stream(1, process.name, static_cast<std::uint64_t>(r), "record", static_cast<std::uint64_t>(cycles));
    const Sample sample(process, cycles, stream);
    count_comparisons(sample, Sample(process, cycles, stream), others);
    others["mean"].add(sample.load.mean_95, truth.mean);
    others["mean by 20 batches"].add(batch_means_interval(sample.history.values, 20), truth.mean);
    const ExtremeValues values =
        extreme_values({{&sample.history, &sample.even, sample.load.autocorrelation_time}}, {});
    for (const double periods : {4.0, 30.0}) count_extremes(process, values, periods, goodness, by_period[periods]);
    count_fatigue(sample.history, truth, values.block, stream, others);
  }
  const auto print = [&](double periods, const Tallies& tallies) {
    for (const auto& [name, tally] : tallies)
      fmt::print("{},{},{},{},{:.3f},{}\n", process.name, cycles, periods, name,
                 static_cast<double>(tally.held) / tally.n, tally.n);
  };
  for (const auto& [periods, tallies] : by_period) print(periods, tallies);
  print(0.0, others);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int records = argc > 1 ? std::atoi(argv[1]) : 5000;
  const std::vector<int> lengths = argc > 2 ? std::vector<int>{std::atoi(argv[2])} : std::vector<int>{100, 400};
  fmt::print("process,cycles,periods,interval,share,n\n");
  for (const int cycles : lengths)
    for (const Process& process : processes()) study(process, cycles, records);
}
