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

Levels levels_of(const ExtremeAnalysis& e, double last) {
  constexpr int kPoints = 14;
  Levels out;
  if (!e.recommended) return out;
  const ExtremeEstimate& law = e.of(*e.recommended);
  const double first = 1.2 / law.rate / kHour;
  for (int i = 0; i < kPoints; ++i) {
    const double hours = first * std::pow(last / first, i / (kPoints - 1.0));
    const auto level = level_of(law, kHour * hours);
    if (!level) continue;
    out.hours.push_back(hours);
    out.level.push_back(level->value);
    out.lower.push_back(level->interval.lower);
    out.upper.push_back(level->interval.upper);
  }
  return out;
}

/// Where the curve of a state ends: no level is given beyond what its record can support.
double last_hours(const analysis::DesignState& state, const analysis::DesignSettings& asked) {
  const double wanted = 1.5 * *std::ranges::max_element(asked.hours);
  return asked.extremes.extrapolate ? wanted
                                    : std::min(wanted, kLongestPeriod * state.extremes.values.duration / kHour);
}

std::string exposure_chart(const analysis::Design& design, const analysis::DesignSettings& asked) {
  std::vector<Levels> all;
  double first = INFINITY, last = 0.0, low = INFINITY, high = 0.0;
  for (const analysis::DesignState& state : design.states) {
    all.push_back(levels_of(state.extremes, last_hours(state, asked)));
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

std::string years_chart(const analysis::Design& design, const analysis::DesignSettings& asked) {
  if (!design.long_term) return "";
  constexpr int kPoints = 14;
  const double first = 0.5, last = 0.5 * *std::ranges::min_element(asked.annual);
  Samples probability, level, lower, upper;
  for (int i = 0; i < kPoints; ++i) {
    // The rarest is the last that the curves know.
    const double p = std::max(first * std::pow(last / first, i / (kPoints - 1.0)), 2.0 * last);
    const Estimate at = design.long_term->level(p);
    probability.push_back(p);
    level.push_back(at.value);
    lower.push_back(at.interval.lower);
    upper.push_back(std::min(at.interval.upper, 3.0 * at.value));
  }
  const double high = std::max(1.1 * level.back(), std::min(upper.back(), 2.0 * level.back()));
  Chart chart(575.0, 30.0, 380.0, 300.0, "level of an annual probability, 95 %", {label(design), lower.front(), high},
              {"annual probability", last, 1.0, true});
  // The band lies between two curves of the level: its outline goes along one and back along the other.
  Samples x = lower, y = probability;
  x.insert(x.end(), upper.rbegin(), upper.rend());
  y.insert(y.end(), probability.rbegin(), probability.rend());
  chart.area(x, y, kLineColours[0]);
  chart.line(level, probability, kLineColours[0], 1.5);
  for (const double p : asked.annual) chart.line({lower.front(), high}, {p, p}, "#777");
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
