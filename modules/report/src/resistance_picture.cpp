// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <vector>

#include "brash/analysis/resistance.hpp"
#include "brash/analysis/tables.hpp"
#include "brash/report/pictures.hpp"
#include "chart.hpp"

namespace brash::report {
namespace {

using nlohmann::ordered_json;
using Samples = std::vector<double>;

constexpr const char* kThrustColour = "#555";
constexpr double kLegendLine = 16.0;  // [pixels]

/// Numbers of the points of one thickness over speed, forces in the picture's unit.
struct Line {
  Samples speed, resistance, lower, upper, lindqvist;
};

/// By thickness [m].
using Lines = std::map<double, Line>;

Lines lines_of(const ordered_json& points, double one) {
  Lines lines;
  for (const ordered_json& point : points) {
    Line& line = lines[point["thickness"].get<double>()];
    const auto add = [&](Samples& to, const ordered_json& force, double otherwise) {
      to.push_back(force.is_number() ? force.get<double>() / one : otherwise);
    };
    line.speed.push_back(point["speed"].get<double>());
    add(line.resistance, point["resistance"], 0.0);
    const ordered_json ends =
        point["resistance_95"].is_array() ? point["resistance_95"] : ordered_json{nullptr, nullptr};
    add(line.lower, ends[0], line.resistance.back());
    add(line.upper, ends[1], line.resistance.back());
    if (point["lindqvist"].is_number()) add(line.lindqvist, point["lindqvist"], 0.0);
  }
  return lines;
}

std::string resistance_chart(const Lines& lines, const ordered_json& resistance,
                             const std::optional<analysis::NetThrust>& thrust, const analysis::TableUnit& unit) {
  double fastest = 0.0, highest = 0.0;
  for (const auto& [thickness, line] : lines) {
    fastest = std::max(fastest, line.speed.back());
    for (const Samples* const of : {&line.upper, &line.lindqvist})
      for (const double value : *of) highest = std::max(highest, value);
  }
  Chart chart(85.0, 30.0, 380.0, 300.0, resistance["case"].get<std::string>() + ": resistance, 95 %",
              {"speed [m/s]", 0.0, upper_end(0.0, fastest)},
              {fmt::format("force [{}]", unit.name), 0.0, upper_end(0.0, highest)});
  std::size_t n = 0;
  for (const auto& [thickness, line] : lines) {
    const char* const colour = kLineColours[n++ % kLineColours.size()];
    chart.line(line.speed, line.resistance, colour, 1.5);
    if (line.lindqvist.size() == line.speed.size()) chart.line(line.speed, line.lindqvist, colour, 0.6);
    for (std::size_t i = 0; i < line.speed.size(); ++i) {
      chart.point(line.speed[i], line.resistance[i], colour, 3.0);
      chart.line({line.speed[i], line.speed[i]}, {line.lower[i], line.upper[i]}, colour);
    }
  }
  if (!thrust) return chart.svg();
  Samples speeds, forces;
  for (int i = 0; i <= 100; ++i) {
    const double speed = fastest * i / 100.0;
    const auto force = thrust->at(speed);
    if (!force || *force / unit.one > upper_end(0.0, highest)) continue;
    speeds.push_back(speed);
    forces.push_back(*force / unit.one);
  }
  chart.line(speeds, forces, kThrustColour, 1.5);
  return chart.svg();
}

std::string attained_chart(const ordered_json& resistance) {
  Samples thicknesses, speeds;
  for (const ordered_json& line : resistance["attained_lines"]) {
    std::ranges::copy(line["thickness"].get<Samples>(), std::back_inserter(thicknesses));
    std::ranges::copy(line["speed"].get<Samples>(), std::back_inserter(speeds));
  }
  std::vector<std::pair<double, Samples>> points;  // thickness; speed, and the ends of its interval
  for (const ordered_json& entry : resistance["attained"]) {
    if (!entry["speed"].is_number()) continue;
    const double speed = entry["speed"].get<double>();
    const auto end = [&](std::size_t i) {
      const ordered_json& value = entry["speed_95"][i];
      return value.is_number() ? value.get<double>() : speed;
    };
    points.push_back({entry["thickness"].get<double>(), {speed, end(0), end(1)}});
    thicknesses.push_back(points.back().first);
    speeds.insert(speeds.end(), {end(0), end(1)});
  }
  if (thicknesses.empty()) return "";
  Chart chart(575.0, 30.0, 380.0, 300.0, "speed that the thrust attains, 95 %",
              {"ice [m]", 0.0, upper_end(0.0, std::ranges::max(thicknesses))},
              {"speed [m/s]", 0.0, upper_end(0.0, std::ranges::max(speeds))});
  for (const ordered_json& line : resistance["attained_lines"])
    chart.line(line["thickness"].get<Samples>(), line["speed"].get<Samples>(), kLineColours[0], 1.5);
  for (const auto& [thickness, of] : points) {
    chart.point(thickness, of[0], kLineColours[0], 3.0);
    chart.line({thickness, thickness}, {of[1], of[2]}, kLineColours[0]);
  }
  return chart.svg();
}

std::string legend(const Lines& lines, bool has_thrust) {
  std::string svg;
  double y = 385.0;
  const auto add = [&](const std::string& text, const char* colour) {
    svg += fmt::format("<text x=\"85\" y=\"{:.0f}\" style=\"fill:{}\">{}</text>\n", y, colour, text);
    y += kLegendLine;
  };
  std::size_t n = 0;
  for (const auto& [thickness, line] : lines)
    add(fmt::format("ice of {:g} m; thin: Lindqvist", thickness), kLineColours[n++ % kLineColours.size()]);
  if (has_thrust) add("net thrust", kThrustColour);
  return svg;
}

}  // namespace

std::string resistance_picture(const ordered_json& resistance, const std::optional<analysis::NetThrust>& thrust) {
  Samples all;
  for (const ordered_json& point : resistance["points"]) all.push_back(point["resistance"].get<double>());
  const analysis::TableUnit unit = analysis::unit_for(all, "N");
  const Lines lines = lines_of(resistance["points"], unit.one);
  const std::string attained = thrust ? attained_chart(resistance) : "";
  return svg_page(attained.empty() ? 500.0 : 1000.0, 390.0 + kLegendLine * static_cast<double>(lines.size() + 1),
                  resistance_chart(lines, resistance, thrust, unit) + attained + legend(lines, thrust.has_value()));
}

}  // namespace brash::report
