// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/analysis/history_growth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "brash/analysis/history_comparison.hpp"
#include "brash/analysis/history_statistics.hpp"
#include "brash/statistics/hypothesis.hpp"
#include "brash/statistics/intervals.hpp"
#include "brash/statistics/moments.hpp"

namespace brash::analysis {
namespace {

using nlohmann::ordered_json;
using statistics::Summary;

constexpr double kConfidence = 0.95;
constexpr std::size_t kWindows = 4;         // of equal travel, whose means are shown
constexpr std::size_t kFewestSamples = 20;  // of a window; fewer give no autocorrelation time

/// Summary of the samples from `from` to `to` after the start of a history [s]; none with too few samples.
std::optional<Summary> summary_between(const LoadHistory& load, double from, double to) {
  const double start = load.history.times.front();
  statistics::History part;
  for (std::size_t i = 0; i < load.history.times.size(); ++i) {
    const double time = load.history.times[i] - start;
    if (time < from || time > to) continue;
    part.times.push_back(load.history.times[i]);
    part.values.push_back(load.history.values[i]);
  }
  if (part.times.size() < kFewestSamples) return std::nullopt;
  return statistics::summarise(part, statistics::make_even(part, load.even.sampling.longest));
}

double duration_of(const LoadHistory& load) { return load.history.times.back() - load.history.times.front(); }

/// The shortest travel of the histories of a side.
double shortest(const std::vector<LoadHistory>& loads, double speed) {
  double least = std::numeric_limits<double>::infinity();
  for (const LoadHistory& load : loads) least = std::min(least, speed * duration_of(load));
  return least;
}

/// The ratio of the means of two halves, as the summary of samples with the relative errors of both.
std::optional<Summary> growth_of(const LoadHistory& load, double half) {
  const auto first = summary_between(load, 0.0, half), second = summary_between(load, half, 2.0 * half);
  if (!first || !second || first->mean <= 0.0 || second->mean <= 0.0) return std::nullopt;
  const auto error = [](const Summary& s) {
    return s.standard_deviation * s.standard_deviation / (s.mean * s.mean * s.effective_sample_size);
  };
  Summary s;
  s.n = first->n + second->n;
  s.mean = second->mean / first->mean;
  s.effective_sample_size = first->effective_sample_size + second->effective_sample_size;
  s.standard_deviation = s.mean * std::sqrt((error(*first) + error(*second)) * s.effective_sample_size);
  return s;
}

/// The growth of a side: of one history with the errors of its halves, of several by their spread.
std::optional<Summary> growth_of(const std::vector<LoadHistory>& loads, double half) {
  std::vector<double> values;
  std::optional<Summary> last;
  for (const LoadHistory& load : loads) {
    last = growth_of(load, half);
    if (!last) return std::nullopt;
    values.push_back(last->mean);
  }
  return loads.size() == 1 ? last : over_replicates(values);
}

/// Mean and interval of each window of a side; null where a history has too few samples, as in a gap.
ordered_json windows_of(const std::vector<LoadHistory>& loads, double duration) {
  ordered_json windows = ordered_json::array();
  for (std::size_t i = 0; i < kWindows; ++i) {
    const double from = duration * static_cast<double>(i) / kWindows;
    const double to = duration * static_cast<double>(i + 1) / kWindows;
    std::vector<double> means;
    std::optional<Summary> last;
    for (const LoadHistory& load : loads)
      if ((last = summary_between(load, from, to))) means.push_back(last->mean);
    ordered_json window{{"from", from}, {"to", to}, {"mean", nullptr}, {"mean_95", nullptr}};
    if (means.size() == loads.size() && loads.size() == 1) {
      window["mean"] = last->mean;
      window["mean_95"] = interval_of_mean(*last);
    } else if (means.size() == loads.size()) {
      const statistics::Interval interval = statistics::mean_interval(means, kConfidence);
      window["mean"] = statistics::moments(means).mean;
      window["mean_95"] = {interval.lower, interval.upper};
    }
    windows.push_back(window);
  }
  return windows;
}

}  // namespace

ordered_json compare_growth(const std::vector<LoadHistory>& runs, const std::vector<LoadHistory>& measured,
                            const IceSpeeds& speeds) {
  const bool known = speeds.run > 0.0 && speeds.measured > 0.0;
  const double of_run = known ? speeds.run : 1.0, of_measured = known ? speeds.measured : 1.0;
  const double travel = std::min(shortest(runs, of_run), shortest(measured, of_measured));
  const auto a = growth_of(runs, 0.5 * travel / of_run), b = growth_of(measured, 0.5 * travel / of_measured);
  if (!a || !b) return nullptr;
  const statistics::RatioComparison c = statistics::compare_ratio(*a, *b, kConfidence);
  return {{"travel", travel},
          {"unit", known ? "m" : "s"},
          {"windows",
           {{"run", windows_of(runs, travel / of_run)}, {"measured", windows_of(measured, travel / of_measured)}}},
          {"growth", {a->mean, b->mean}},
          {"ratio", c.ratio},
          {"ratio_95", {c.interval.lower, c.interval.upper}},
          {"p", c.test.p_value}};
}

}  // namespace brash::analysis
