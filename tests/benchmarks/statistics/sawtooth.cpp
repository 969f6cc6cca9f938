// SPDX-License-Identifier: GPL-3.0-or-later
#include "sawtooth.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "brash/analysis/history_statistics.hpp"
#include "brash/statistics/moments.hpp"
#include "brash/statistics/quantile.hpp"

namespace brash::coverage {
namespace {

using namespace statistics;

constexpr double kStep = 0.05;      // [s]
constexpr double kResidual = 20.0;  // load after a drop

double normal_quantile(double exceedance) {
  double low = -12.0, high = 12.0;  // of a deviation
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(middle / std::sqrt(2.0)) > exceedance ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Mean of a function of the peak.
double mean_over_peaks(const Process& process, const std::function<double(double)>& of) {
  constexpr double kFarthest = 80.0, kWidth = 0.02;  // of the logarithm of the probability
  double sum = 0.0;
  for (double s = 0.5 * kWidth; s < kFarthest; s += kWidth)
    sum += kWidth * std::exp(-s) * of(process.peak(std::exp(-s)));
  return sum;
}

int samples_of_cycle(double normal) { return static_cast<int>(std::round(std::max(0.3, 1.0 + 0.3 * normal) / kStep)); }

/// Peaks with a slow change: a first-order process, drawn only where it has a deviation.
class SlowChange {
 public:
  SlowChange(double deviation, RandomStream& stream)
      : deviation_(deviation), stream_(stream), state_(deviation > 0.0 ? stream.normal() : 0.0) {}

  /// Factor of the next peak, `elapsed` [s] after the last one.
  double next(double elapsed) {
    if (deviation_ == 0.0) return 1.0;
    const double kept = std::exp(-elapsed / kMemory);
    state_ = kept * state_ + std::sqrt(1.0 - kept * kept) * stream_.normal();
    return 1.0 + deviation_ * state_;
  }

 private:
  static constexpr double kMemory = 10.0;  // [s]
  double deviation_;
  RandomStream& stream_;
  double state_;
};

History samples(const Process& process, int cycles, RandomStream& stream, double scale, double slow) {
  History history;
  SlowChange change(slow, stream);
  for (double time = 0.0; time < cycles;) {
    const int n = samples_of_cycle(stream.normal());
    const double height = (process.peak(stream.uniform() + 0x1p-49) - kResidual) * change.next(n * kStep);
    for (int i = 0; i < n; ++i) {
      history.times.push_back(kStep * static_cast<double>(history.times.size()));
      history.values.push_back(scale * (kResidual + height * i / (n - 1)));
    }
    time += n * kStep;
  }
  return history;
}

}  // namespace

std::vector<Process> processes() {
  return {{"uniform", [](double q) { return 300.0 - 200.0 * q; }},
          {"normal", [](double q) { return std::max(30.0, 200.0 + 40.0 * normal_quantile(q)); }},
          {"Rayleigh", [](double q) { return 40.0 + 80.0 * std::sqrt(-2.0 * std::log(q)); }},
          {"exponential", [](double q) { return 100.0 - 40.0 * std::log(q); }},
          {"Pareto 0.15", [](double q) { return 100.0 + 40.0 / 0.15 * (std::pow(q, -0.15) - 1.0); }}};
}

analysis::LoadHistory record(const Process& process, int cycles, RandomStream& stream, double scale, double slow) {
  analysis::LoadHistory load;
  load.column = "Fx";
  load.history = samples(process, cycles, stream, scale, slow);
  load.even = make_even(load.history);
  return load;
}

double mean_cycle() {
  double sum = 0.0, weights = 0.0;
  for (double z = -8.0; z < 8.0; z += 1e-4) {
    const double weight = std::exp(-0.5 * z * z);
    weights += weight;
    sum += weight * kStep * samples_of_cycle(z);
  }
  return sum / weights;
}

double mean_load(const Process& process) {
  return kResidual + 0.5 * mean_over_peaks(process, [](double peak) { return peak - kResidual; });
}

Truth truth_of(const Process& process, double segment) {
  RandomStream stream(9, process.name, 0, "truth");
  const int cycles = 100'000;
  const analysis::LoadHistory load = record(process, cycles, stream);
  Truth truth;
  const std::vector<double>& values = load.history.values;
  truth.deviation = std::sqrt(moments(values).variance);
  const auto q = quantiles(values, std::array{0.5, 0.95, 0.99});
  truth.quantile_50 = q[0];
  truth.quantile_95 = q[1];
  truth.quantile_99 = q[2];
  truth.spectrum = analysis::spectrum_of(load, segment).value().density;
  return truth;
}

double damage_of_cycle(const Process& process, double exponent) {
  return mean_over_peaks(process, [&](double peak) { return std::pow(peak - kResidual, exponent); });
}

}  // namespace brash::coverage
