// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "brash/analysis/design.hpp"
#include "brash/report/pictures.hpp"
#include "chart.hpp"

namespace brash::report {
namespace {

using namespace statistics;
using Samples = std::vector<double>;

constexpr double kHour = 3600.0;      // [s]
constexpr double kLegendLine = 16.0;  // [pixels]

std::string label(const analysis::Design& design) {
  return design.unit.empty() ? "load" : fmt::format("load [{}]", design.unit);
}

/// Levels of one state against hours of exposure.
struct Levels {
  Samples hours, level, lower, upper;
};

Levels levels_of(const analysis::Design& design, const analysis::DesignState& state, double last) {
  constexpr int kPoints = 14;
  Levels out;
  if (!design.tail || !state.in_tail) return out;
  const double first = 1.2 * state.extremes.duration / kHour / static_cast<double>(state.extremes.over.size());
  for (int i = 0; i < kPoints; ++i) {
    const double hours = first * std::pow(last / first, i / (kPoints - 1.0));
    const auto level = design.tail->level(design.exposure(state, hours));
    if (!level) continue;
    out.hours.push_back(hours);
    out.level.push_back(level->value);
    out.lower.push_back(level->interval.lower);
    out.upper.push_back(level->interval.upper);
  }
  return out;
}

std::string exposure_chart(const analysis::Design& design, const analysis::DesignSettings& asked) {
  std::vector<Levels> all;
  double first = INFINITY, last = 0.0, low = INFINITY, high = 0.0;
  for (const analysis::DesignState& state : design.states) {
    all.push_back(levels_of(design, state, 1.5 * std::ranges::max(asked.hours)));
    if (all.back().hours.empty()) continue;
    last = std::max(last, all.back().hours.back());
    first = std::min(first, all.back().hours.front());
    low = std::min(low, all.back().lower.front());
    high = std::max(high, 1.3 * all.back().level.back());
  }
  if (!(first < last) || !(low < high)) return "";
  Chart chart(85.0, 30.0, 380.0, 300.0, "level once in the exposure, 95 %", {"exposure [h]", first, last, true},
              {label(design), low, high});
  for (std::size_t i = 0; i < all.size(); ++i) {
    const char* colour = kLineColours[i % kLineColours.size()];
    for (double& end : all[i].upper) end = std::min(end, 2.0 * high);
    chart.band(all[i].hours, all[i].lower, all[i].upper, colour);
    chart.line(all[i].hours, all[i].level, colour, 1.5);
  }
  return chart.svg();
}

/// The level over the return period, with the crushing of all contacts where the cases are known.
std::string years_chart(const analysis::Design& design, const analysis::DesignSettings& asked) {
  if (!design.json.contains("annual") || !design.json["annual"].is_array()) return "";
  constexpr int kPoints = 20;
  const auto [shortest, longest] = std::ranges::minmax(asked.years);
  const double first = 0.5 * shortest, last = 2.0 * longest;
  Samples years, level, lower, upper;
  for (int i = 0; i < kPoints; ++i) {
    const double period = first * std::pow(last / first, i / (kPoints - 1.0));
    const auto at = design.tail->level(design.exposure(period));
    if (!at) continue;
    years.push_back(period);
    level.push_back(at->value);
    lower.push_back(at->interval.lower);
    upper.push_back(at->interval.upper);
  }
  if (years.size() < 2) return "";
  const double high = std::min(1.05 * upper.back(), 3.0 * level.back());
  for (double& end : upper) end = std::min(end, high);
  Chart chart(575.0, 30.0, 380.0, 300.0, "level of a return period, 95 %", {"return period [years]", first, last, true},
              {label(design), 0.0, high});
  chart.band(years, lower, upper, kLineColours[0]);
  chart.line(years, level, kLineColours[0], 1.5);
  for (const double period : asked.years) chart.line({period, period}, {0.0, high}, "#bbb");
  if (design.json.contains("full_crushing"))
    chart.line({first, last}, std::vector<double>(2, design.json["full_crushing"]["horizontal"].get<double>()), "#c00");
  return chart.svg();
}

std::string legend(const analysis::Design& design) {
  std::string svg;
  double y = 385.0;
  for (std::size_t i = 0; i < design.states.size(); ++i, y += kLegendLine)
    svg += fmt::format("<text x=\"85\" y=\"{:.0f}\" style=\"fill:{}\">{}</text>\n", y,
                       kLineColours[i % kLineColours.size()], design.states[i].setting->name);
  return svg;
}

}  // namespace

std::string design_picture(const analysis::Design& design, const analysis::DesignSettings& asked) {
  const std::string years = years_chart(design, asked);
  return svg_page(years.empty() ? 500.0 : 1000.0, 390.0 + kLegendLine * static_cast<double>(design.states.size()),
                  exposure_chart(design, asked) + years + legend(design));
}

}  // namespace brash::report
