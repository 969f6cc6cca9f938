// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "brash/analysis/resistance.hpp"
#include "brash/analysis/tables.hpp"

namespace brash::analysis {
namespace {

using nlohmann::ordered_json;

constexpr std::array kForces{"breaking", "pieces", "friction", "lindqvist", "riska", "jeong"};

/// A number with so many digits after the point; "-" where there is none.
std::string number(const ordered_json& value, double one, int digits) {
  return value.is_number() ? fmt::format("{:.{}f}", value.get<double>() / one, digits) : "-";
}

/// "377 (354 to 399)", in units of `one`; an end that is not known is named.
std::string with_interval(const ordered_json& value, const ordered_json& ends, double one, int digits) {
  std::string text = number(value, one, digits);
  if (!ends.is_array() || (ends[0].is_null() && ends[1].is_null())) return text;
  const auto end = [&](std::size_t i, const char* none) {
    return ends[i].is_null() ? std::string(none) : number(ends[i], one, digits);
  };
  return text + fmt::format(" ({} to {})", end(0, "no lower end"), end(1, "no upper end"));
}

/// The points that are not steady, by the reason.
std::string unsteady_text(const ordered_json& points) {
  std::map<std::string, std::vector<std::string>> by_reason;
  for (const ordered_json& p : points)
    if (p.contains("reason"))
      by_reason[p["reason"].get<std::string>()].push_back(
          fmt::format("{:g} m at {:g} m/s", p["thickness"].get<double>(), p["speed"].get<double>()));
  std::string text;
  for (const auto& [reason, places] : by_reason) {
    const bool all = places.size() > 1 && places.size() == points.size();
    const std::string named =
        all ? fmt::format("all {} points", places.size()) : fmt::format("{}", fmt::join(places, ", "));
    text += fmt::format("  not steady: {} ({})\n", reason, named);
  }
  return text;
}

std::string points_text(const ordered_json& points, const TableUnit& unit) {
  const int digits = unit.one >= 1e3 ? 0 : 1;
  std::string text = fmt::format("{:>7}{:>10}{:>6}  {:<22}{:>9}{:>8}{:>10}{:>10}{:>8}{:>8}{:>9}\n", "ice", "speed",
                                 "runs", fmt::format("resistance [{}]", unit.name), "breaking", "pieces", "friction",
                                 "Lindqvist", "Riska", "Jeong", "covered");
  for (const ordered_json& p : points) {
    const auto force = [&](const char* name) { return number(p[name], unit.one, digits); };
    text += fmt::format("{:>5.2f} m{:>6.2f} m/s{:>6}  {:<22}{:>9}{:>8}{:>10}{:>10}{:>8}{:>8}{:>7.0f} %{}\n",
                        p["thickness"].get<double>(), p["speed"].get<double>(), p["runs"].get<std::size_t>(),
                        with_interval(p["resistance"], p["resistance_95"], unit.one, digits), force("breaking"),
                        force("pieces"), force("friction"), force("lindqvist"), force("riska"), force("jeong"),
                        100.0 * p["covered_bottom"].get<double>(), p["steady"].get<bool>() ? "" : "  not steady");
  }
  return text +
         "  resistance: mean of the runs, with its 95 % interval\n"
         "  breaking: load on unbroken ice, with its friction; pieces, friction: normal forces and friction of broken "
         "ice\n"
         "  covered: share of the hull's bottom that broken ice covers\n" +
         unsteady_text(points);
}

std::string fit_text(const ordered_json& fit, const TableUnit& unit) {
  if (fit.contains("refused")) return fmt::format("no fit: {}\n", fit["refused"].get<std::string>());
  const auto term = [&](const char* name, double one, int digits) {
    return with_interval(fit[name]["value"], fit[name]["interval_95"], one, digits);
  };
  return fmt::format("R = k h^b v^n in m and m/s, {} runs: k = {} {}, b = {}, n = {}; a run scatters by {:.0f} %\n",
                     fit["runs"].get<std::size_t>(), term("k", unit.one, 0), unit.name, term("b", 1.0, 2),
                     term("n", 1.0, 2), 100.0 * fit["spread"].get<double>());
}

std::string attained_text(const ordered_json& entry) {
  const double thickness = entry["thickness"].get<double>();
  if (!entry.contains("outside"))
    return fmt::format("{:>5.2f} m  {} m/s\n", thickness, with_interval(entry["speed"], entry["speed_95"], 1.0, 2));
  const auto outside = entry["outside"].get<std::string>();
  const char* const why = outside == "above"   ? "more than the fastest run"
                          : outside == "below" ? "less than the slowest run, or none"
                                               : "the thrust is not known at these speeds";
  return fmt::format("{:>5.2f} m  {}\n", thickness, why);
}

std::string thickness_text(const ordered_json& at) {
  const double speed = at["speed"].get<double>();
  if (!at.contains("outside"))
    return fmt::format("thickness at {:.2f} m/s: {} m\n", speed,
                       with_interval(at["thickness"], at["thickness_95"], 1.0, 2));
  const auto outside = at["outside"].get<std::string>();
  const std::string why = outside == "above"     ? "more than the thickest ice"
                          : outside == "below"   ? "less than the thinnest ice"
                          : outside == "unknown" ? "the thrust is not known at this speed"
                                                 : outside;
  return fmt::format("thickness at {:.2f} m/s: {}\n", speed, why);
}

}  // namespace

std::string resistance_text(const ordered_json& resistance) {
  std::vector<double> all;
  for (const ordered_json& point : resistance["points"]) all.push_back(point["resistance"].get<double>());
  const TableUnit unit = unit_for(all, "N");
  std::string text = fmt::format("{}: resistance\n", resistance["case"].get<std::string>()) + origin_text(resistance) +
                     points_text(resistance["points"], unit) + fit_text(resistance["fit"], unit);
  const auto is_unsteady = [](const ordered_json& point) { return !point["steady"].get<bool>(); };
  if (std::ranges::any_of(resistance["points"], is_unsteady))
    text += "  the law, and the speeds and the thickness below, are of means that are not steady\n";
  if (!resistance.contains("attained")) return text;
  text += "speed that the thrust attains\n";
  for (const ordered_json& entry : resistance["attained"]) text += attained_text(entry);
  return text + thickness_text(resistance["thickness_at"]);
}

std::string resistance_csv(const ordered_json& resistance) {
  std::string text = "thickness,speed,runs,resistance,lower_95,upper_95";
  for (const char* const name : kForces) text += fmt::format(",{}", name);
  text += ",covered_bottom,steady\n";
  const auto cell = [](const ordered_json& value) {
    return value.is_number() ? fmt::format("{:.9g}", value.get<double>()) : std::string();
  };
  for (const ordered_json& p : resistance["points"]) {
    const ordered_json ends = p["resistance_95"].is_array() ? p["resistance_95"] : ordered_json{nullptr, nullptr};
    text += fmt::format("{},{},{},{},{},{}", cell(p["thickness"]), cell(p["speed"]), cell(p["runs"]),
                        cell(p["resistance"]), cell(ends[0]), cell(ends[1]));
    for (const char* const name : kForces) text += "," + cell(p[name]);
    text += fmt::format(",{},{}\n", cell(p["covered_bottom"]), p["steady"].get<bool>() ? 1 : 0);
  }
  return text;
}

}  // namespace brash::analysis
