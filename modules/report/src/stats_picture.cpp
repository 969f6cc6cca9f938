// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "brash/report/pictures.hpp"
#include "brash/statistics/moments.hpp"
#include "chart.hpp"

namespace brash::report {
namespace {

using namespace statistics;
using Samples = std::vector<double>;

constexpr const char* kLoad = "#1f4e79";
constexpr const char* kMark = "#b3261e";
constexpr double kChartHeight = 235.0, kChartWidth = 240.0;

/// The law that is drawn: the recommended one, else the first that was fitted.
const ExtremeEstimate* drawn(const ExtremeAnalysis& analysis) {
  if (analysis.recommended) return &analysis.of(*analysis.recommended);
  for (const Law law : {Law::kGev, Law::kPareto, Law::kGumbel, Law::kWeibull})
    if (analysis.of(law).fit) return &analysis.of(law);
  return nullptr;
}

std::string quantile_chart(const ExtremeEstimate& e, const std::string& unit, double left, double top) {
  const Samples& values = e.fit->values;
  const auto n = static_cast<double>(values.size());
  Samples expected;
  for (std::size_t i = 0; i < values.size(); ++i)
    expected.push_back(e.fit->distribution.level(1.0 - (static_cast<double>(i) + 0.5) / n));
  const double low = std::min(expected.front(), values.front()), high = std::max(expected.back(), values.back());
  const double margin = 0.05 * (high - low);
  Chart chart(left, top, kChartWidth, kChartHeight, fmt::format("quantiles: {}", name_of(e.law)),
              {axis_label("load by the law", unit), low - margin, high + margin},
              {axis_label("load", unit), low - margin, high + margin});
  chart.line({low, high}, {low, high}, "#333");
  for (std::size_t i = 0; i < values.size(); ++i) chart.point(expected[i], values[i], kLoad, 2.5);
  return chart.svg();
}

/// Values of the fit at the return periods at which they were exceeded.
void draw_values(const ExtremeEstimate& e, Chart& chart) {
  const Samples& values = e.fit->values;
  const auto n = static_cast<double>(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    chart.point((n + 1.0) / ((n - static_cast<double>(i)) * e.rate), values[i], kLoad, 2.5);
}

std::string level_chart(const ExtremeAnalysis& analysis, const ExtremeEstimate& e, const std::string& unit, double left,
                        double top) {
  constexpr int kPeriods = 16;
  const double first = 1.2 / e.rate;
  const double last = std::max(analysis.values.duration, e.level ? analysis.return_period : 0.0) * 1.5;
  Samples periods, levels, lower, upper;
  for (const double period : at_equal_ratios(first, last, kPeriods)) {
    const auto level = level_of(e, period);
    if (!level) continue;
    periods.push_back(period);
    levels.push_back(level->value);
    lower.push_back(level->interval.lower);
    upper.push_back(level->interval.upper);
  }
  double high = e.fit->values.back();
  for (std::size_t i = 0; i < upper.size(); ++i) high = std::max(high, std::isfinite(upper[i]) ? upper[i] : levels[i]);
  const double low = std::min(e.fit->values.front(), lower.empty() ? e.fit->values.front() : lower.front());
  const double top_level = upper_end(low, high);
  for (double& end : upper) end = std::min(end, 2.0 * top_level - low);  // beyond the drawing
  Chart chart(left, top, kChartWidth, kChartHeight, "level once in a return period",
              {"return period [s]", first, last, true}, {axis_label("load", unit), low, top_level});
  chart.curve(periods, levels, lower, upper, kLoad);
  draw_values(e, chart);
  if (e.level) chart.line({analysis.return_period, analysis.return_period}, {low, top_level}, kMark);
  return chart.svg();
}

std::string threshold_chart(const ExtremeAnalysis& analysis, const std::string& unit, double left, double top) {
  const auto fits = threshold_stability(analysis.values, std::max(analysis.return_period, analysis.values.cycle));
  if (fits.empty()) return "";
  double low = -0.6, high = 0.6;
  Samples thresholds, shapes;
  for (const ThresholdFit& fit : fits) {
    thresholds.push_back(fit.threshold);
    shapes.push_back(fit.shape);
    low = std::min(low, fit.shape - 0.1);
    high = std::max(high, fit.shape + 0.1);
  }
  const double margin = 0.05 * (thresholds.back() - thresholds.front());
  Chart chart(left, top, kChartWidth, kChartHeight, "shape of Pareto against the threshold",
              {axis_label("threshold", unit), thresholds.front() - margin, thresholds.back() + margin},
              {"shape", low, high});
  // The error of the shape is (1 + shape)/sqrt(peaks).
  for (std::size_t i = 0; i < fits.size(); ++i) {
    const double error = 2.0 * (1.0 + fits[i].shape) / std::sqrt(static_cast<double>(fits[i].peaks));
    chart.line({thresholds[i], thresholds[i]}, {fits[i].shape - error, fits[i].shape + error}, kLoad, 2.0);
    chart.point(thresholds[i], fits[i].shape, kLoad, 3.5);
  }
  chart.line({analysis.values.threshold, analysis.values.threshold}, {low, high}, kMark);
  return chart.svg();
}

std::string history_chart(const analysis::LoadHistory& load, const ExtremeAnalysis& analysis,
                          const std::vector<LoadEvent>& events) {
  const auto [smallest, largest] = std::ranges::minmax(load.history.values);
  const double low = std::min(0.0, smallest), high = upper_end(low, std::max(0.0, largest));
  Chart chart(75.0, 30.0, 900.0, 130.0, fmt::format("{} with {} load events", load.column, events.size()),
              {"time [s]", load.history.times.front(), load.history.times.back()},
              {axis_label("load", load.unit), low, high});
  chart.history(load.history.times, load.history.values, load.even.cuts, kLoad);
  for (const LoadEvent& event : events) chart.point(event.peak_time, event.peak, kMark, 2.0);
  chart.line({load.history.times.front(), load.history.times.back()}, {analysis.values.mean, analysis.values.mean},
             "#777");
  return chart.svg();
}

}  // namespace

std::string extremes_charts(const ExtremeAnalysis& analysis, const std::string& unit, double left, double top) {
  const ExtremeEstimate* e = drawn(analysis);
  if (e == nullptr) return "";
  return quantile_chart(*e, unit, left, top) + level_chart(analysis, *e, unit, left + 325.0, top) +
         threshold_chart(analysis, unit, left + 650.0, top);
}

std::string stats_picture(const analysis::LoadHistory& load, const analysis::StatisticsSettings& settings) {
  const ExtremeAnalysis analysis = analysis::extremes_of(load, settings.extremes);
  const std::string extremes = extremes_charts(analysis, load.unit, 85.0, 240.0);
  return svg_page(1000.0, extremes.empty() ? 210.0 : 540.0,
                  history_chart(load, analysis, analysis::events_of(load, settings.extremes.dead_band)) + extremes);
}

}  // namespace brash::report
