// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "brash/analysis/history_comparison.hpp"
#include "brash/analysis/history_statistics.hpp"
#include "brash/report/pictures.hpp"
#include "brash/statistics/spectrum.hpp"
#include "chart.hpp"

namespace brash::report {
namespace {

using nlohmann::ordered_json;
using Samples = std::vector<double>;

constexpr double kPageWidth = 1000.0, kPageHeight = 700.0;
constexpr const char* kRun = "#1f4e79";
constexpr const char* kMeasured = "#b3261e";
constexpr const char* kMean = "#000";
constexpr double kRows = 5.0;              // of ratios
constexpr std::size_t kMostPoints = 4000;  // of a drawn history

double largest_of(const Samples& a, const Samples& b) {
  return std::max(*std::ranges::max_element(a), *std::ranges::max_element(b));
}
double smallest_of(const Samples& a, const Samples& b) {
  return std::min(*std::ranges::min_element(a), *std::ranges::min_element(b));
}

void draw_history(const analysis::LoadHistory& load, double origin, const char* colour, Chart& chart) {
  Samples times = load.history.times;
  for (double& time : times) time -= origin;
  chart.history(times, load.history.values, load.even.cuts, colour);
}

using Names = std::array<std::string, 2>;

/// Means of successive windows with their intervals, over the time from the start.
void draw_growth(const ordered_json& windows, Chart& chart) {
  for (const ordered_json& window : windows) {
    if (window["mean"].is_null()) continue;
    const double from = window["from"].get<double>(), to = window["to"].get<double>(),
                 mean = window["mean"].get<double>();
    chart.line({from, to}, {mean, mean}, kMean, 2.0);
    const ordered_json& ends = window["mean_95"];
    if (!ends.is_array() || ends[0].is_null() || ends[1].is_null()) continue;
    chart.line({0.5 * (from + to), 0.5 * (from + to)}, {ends[0].get<double>(), ends[1].get<double>()}, kMean, 1.0);
  }
}

/// The verdict in one line.
std::string verdict(const ordered_json& comparison) {
  const ordered_json& differs = comparison["differs"];
  if (differs.is_null()) return "no verdict: too few independent samples";
  if (differs.empty()) return "no difference at 5 %";
  return fmt::format("different at 5 %: {}", fmt::join(differs.get<std::vector<std::string>>(), ", "));
}

std::string histories(const analysis::LoadHistory& run, const analysis::LoadHistory& measured,
                      const ordered_json& comparison, const Names& names) {
  const double start_a = run.history.times.front(), start_b = measured.history.times.front();
  const double end = std::max(run.history.times.back() - start_a, measured.history.times.back() - start_b);
  const double low = std::min(0.0, smallest_of(run.history.values, measured.history.values));
  const double high = upper_end(low, std::max(0.0, largest_of(run.history.values, measured.history.values)));
  std::string svg;
  const auto panel = [&](const analysis::LoadHistory& load, double start, double top, const std::string& name,
                         const char* side, const char* colour) {
    Chart chart(75.0, top, 900.0, 110.0, fmt::format("{}: {}", name, load.column),
                {top > 100.0 ? "time from the start [s]" : "", 0.0, end}, {axis_label("load", load.unit), low, high});
    draw_history(load, start, colour, chart);
    if (comparison.contains("growth")) draw_growth(comparison["growth"]["windows"][side], chart);
    svg += chart.svg();
  };
  panel(run, start_a, 30.0, names[0], "run", kRun);
  panel(measured, start_b, 180.0, names[1], "measured", kMeasured);
  return svg;
}

std::string ratios(const ordered_json& comparison, const Names& sides) {
  const std::array<std::pair<const char*, const char*>, 5> rows{{{"mean", "mean"},
                                                                 {"deviation", "deviation"},
                                                                 {"mean_peak", "mean peak"},
                                                                 {"peak_rate", "peaks a second"},
                                                                 {"growth", "growth"}}};
  double lower = 0.5, upper = 2.0;
  for (const auto& [key, name] : rows) {
    if (!comparison.contains(key) || !comparison[key].contains("ratio")) continue;
    lower = std::min(lower, 0.9 * comparison[key]["ratio_95"][0].get<double>());
    upper = std::max(upper, 1.1 * comparison[key]["ratio_95"][1].get<double>());
  }
  Chart chart(110.0, 375.0, 210.0, 260.0, fmt::format("{} / {}, 95 %", sides[0], sides[1]), {"ratio", lower, upper},
              {"", 0.0, kRows});
  chart.line({1.0, 1.0}, {0.0, kRows}, "#333");
  std::string names;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& [key, name] = rows[i];
    const double y = kRows - 0.5 - static_cast<double>(i);
    names += fmt::format("<text x=\"105\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n",
                         379.0 + 260.0 / kRows * (kRows - y), name);
    if (!comparison.contains(key) || !comparison[key].contains("ratio")) continue;
    const ordered_json& c = comparison[key];
    chart.interval(c["ratio"].get<double>(), c["ratio_95"][0].get<double>(), c["ratio_95"][1].get<double>(), y, kRun);
  }
  return chart.svg() + names;
}

/// Share of time above each load.
void draw_exceedance(const analysis::LoadHistory& load, const char* colour, Chart& chart) {
  std::vector<std::pair<double, double>> sorted;
  for (std::size_t i = 0; i < load.history.values.size(); ++i)
    sorted.emplace_back(load.history.values[i], load.even.weight(i));
  std::ranges::sort(sorted);
  Samples x, y;
  double above = load.even.duration;
  const std::size_t stride = std::max<std::size_t>(1, sorted.size() / kMostPoints);
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    above -= sorted[i].second;
    if (i % stride != 0 && i + 100 < sorted.size()) continue;  // every one of the largest
    x.push_back(sorted[i].first);
    y.push_back(above / load.even.duration);
  }
  chart.line(x, y, colour, 1.5);
}

std::string distributions(const analysis::LoadHistory& run, const analysis::LoadHistory& measured) {
  const double low = std::min(0.0, smallest_of(run.history.values, measured.history.values));
  const double high = upper_end(low, std::max(0.0, largest_of(run.history.values, measured.history.values)));
  Chart chart(405.0, 375.0, 235.0, 260.0, "share of time above a load", {axis_label("load", run.unit), low, high},
              {"share", 1e-4, 1.0, true});
  draw_exceedance(run, kRun, chart);
  draw_exceedance(measured, kMeasured, chart);
  return chart.svg();
}

void draw_spectrum(const statistics::Spectrum& spectrum, const char* colour, Chart& chart) {
  const statistics::Interval factors = statistics::spectrum_factors(spectrum);
  const Samples f(spectrum.frequency.begin() + 1, spectrum.frequency.end());
  const Samples s(spectrum.density.begin() + 1, spectrum.density.end());
  Samples lower = s, upper = s;
  for (double& x : lower) x *= factors.lower;
  for (double& x : upper) x *= factors.upper;
  chart.curve(f, s, lower, upper, colour, 1.2);
}

std::string spectra(const analysis::LoadHistory& run, const analysis::LoadHistory& measured,
                    const ordered_json& comparison) {
  if (comparison["spectrum"].is_null()) return "";
  const double segment = comparison["spectrum"]["segment"].get<double>();
  const statistics::Spectrum a = *analysis::spectrum_of(run, segment), b = *analysis::spectrum_of(measured, segment);
  const double high = 3.0 * largest_of(a.density, b.density);
  Chart chart(
      730.0, 375.0, 245.0, 260.0, "spectra with 95 % bands",
      {"frequency [Hz]", std::min(a.frequency[1], b.frequency[1]), std::max(a.frequency.back(), b.frequency.back()),
       true},
      {axis_label("density", run.unit.empty() ? "" : fmt::format("({})²/Hz", run.unit)), 1e-7 * high, high, true});
  draw_spectrum(a, kRun, chart);
  draw_spectrum(b, kMeasured, chart);
  return chart.svg();
}

}  // namespace

std::string comparison_picture(const analysis::LoadHistory& run, const analysis::LoadHistory& measured,
                               const ordered_json& comparison) {
  const Names names = analysis::side_names(comparison);
  const std::string legend = fmt::format(
      "<text x=\"110\" y=\"692\" style=\"fill:{}\">{}</text><text x=\"190\" y=\"692\" style=\"fill:{}\">{}</text>"
      "<text x=\"310\" y=\"692\" style=\"fill:{}\">{}</text><text x=\"480\" y=\"692\">{}</text>\n",
      kRun, names[0], kMeasured, names[1], kMean, comparison.contains("growth") ? "means of quarters" : "",
      verdict(comparison));
  return svg_page(kPageWidth, kPageHeight,
                  histories(run, measured, comparison, names) + ratios(comparison, names) +
                      distributions(run, measured) + spectra(run, measured, comparison) + legend);
}

}  // namespace brash::report
