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

constexpr double kHour = 3600.0;  // [s]

/// Levels of one state against hours of exposure.
struct Levels {
  Samples hours, level, lower, upper;
};

Levels levels_of(const analysis::Design& design, const analysis::DesignState& state, double last) {
  constexpr int kPoints = 14;
  Levels out;
  if (!design.tail || !state.in_tail) return out;
  const double first = 1.2 * state.extremes.duration / kHour / static_cast<double>(state.extremes.over.size());
  for (const double hours : at_equal_ratios(first, last, kPoints)) {
    const auto level = design.tail->level(design.exposure(state, hours));
    if (!level) continue;
    out.hours.push_back(hours);
    out.level.push_back(level->value);
    out.lower.push_back(level->interval.lower);
    out.upper.push_back(level->interval.upper);
  }
  return out;
}

/// A panel for each state: bands of several states in one would lie over each other.
struct Panels {
  std::string svg;
  double width = 0.0;   ///< [pixels]
  double height = 0.0;  ///< with the numbers and the label under them [pixels]
};

constexpr std::size_t kColumns = 3;
constexpr double kPanel = 330.0, kPanelHeight = 240.0;  // from one to the next

Panels exposure_panels(const analysis::Design& design, const analysis::DesignSettings& asked) {
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
  Panels panels{.svg = "<text x=\"85\" y=\"20\">no state has a level</text>\n", .width = 340.0, .height = 30.0};
  if (!(first < last) || !(low < high)) return panels;
  panels.svg = "<text x=\"85\" y=\"20\" style=\"font-weight:bold\">level once in the exposure, 95 %</text>\n";
  std::size_t n = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].hours.empty()) continue;
    const double left = 85.0 + kPanel * static_cast<double>(n % kColumns);
    const double top = 50.0 + kPanelHeight * std::floor(static_cast<double>(n) / kColumns);
    Chart chart(left, top, 230.0, 160.0, design.states[i].setting->name, {"exposure [h]", first, last, true},
                {axis_label("load", design.unit), low, high});
    for (double& end : all[i].upper) end = std::min(end, 2.0 * high);
    chart.curve(all[i].hours, all[i].level, all[i].lower, all[i].upper, kLineColours[0]);
    panels.svg += chart.svg();
    panels.width = std::max(panels.width, left + 255.0);
    panels.height = top + kPanelHeight - 30.0;
    ++n;
  }
  return panels;
}

/// The level over the return period, and the crushing of the ice over the full width where the cases are known.
/// @param top  of the plotted area [pixels].
std::string years_chart(const analysis::Design& design, const analysis::DesignSettings& asked, double top) {
  if (!design.json.contains("annual") || !design.json["annual"].is_array()) return "";
  constexpr int kPoints = 20;
  const auto [shortest, longest] = std::ranges::minmax(asked.years);
  const double first = 0.5 * shortest, last = 2.0 * longest;
  Samples years, level, lower, upper;
  for (const double period : at_equal_ratios(first, last, kPoints)) {
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
  Chart chart(85.0, top, 560.0, 300.0, "level of a return period, 95 %", {"return period [years]", first, last, true},
              {axis_label("load", design.unit), 0.0, high});
  chart.curve(years, level, lower, upper, kLineColours[0]);
  for (const double period : asked.years) chart.line({period, period}, {0.0, high}, "#bbb");
  if (design.json.contains("full_crushing")) {
    const double crushing = design.json["full_crushing"]["horizontal"].get<double>();
    chart.line({first, last}, {crushing, crushing}, "#c00");
    if (crushing < high) chart.words(1.1 * first, 1.02 * crushing, "the ice over the full width crushes", "#c00");
  }
  return chart.svg();
}

}  // namespace

std::string design_picture(const analysis::Design& design, const analysis::DesignSettings& asked) {
  const Panels panels = exposure_panels(design, asked);
  const double top = panels.height + 30.0;
  const std::string years = years_chart(design, asked, top);
  return svg_page(years.empty() ? panels.width : std::max(panels.width, 670.0),
                  years.empty() ? panels.height + 10.0 : top + 345.0, panels.svg + years);
}

}  // namespace brash::report
