// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/analysis/resistance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <utility>

#include "brash/analysis/campaign_histories.hpp"
#include "brash/analysis/case_forms.hpp"
#include "brash/analysis/closed_forms.hpp"
#include "brash/analysis/tables.hpp"
#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/io/case.hpp"
#include "brash/io/run_summary.hpp"
#include "brash/statistics/intervals.hpp"
#include "brash/statistics/power_law.hpp"

namespace brash::analysis {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using statistics::Interval;

constexpr const char* kRunSummary = "the summary.json of a run of a ship";
/// The least way before a mean is called steady, in lengths of the hull. Chosen: after 1.2 the bottom of
/// experiments/ships/icebreaker.toml still gathered ice.
constexpr double kSteadyLengths = 2.5;
constexpr const char* kFillingHull = "filling-hull";  // warning of a run whose bottom still gathers ice

/// One run of a ship.
struct Run {
  double resistance = 0.0;         ///< mean [N]
  std::optional<Interval> within;  ///< its 95 % interval within the run
  double breaking = 0.0, pieces = 0.0, friction = 0.0;
  double covered_bottom = 0.0;
  double statistics_from = 0.0;  ///< [s]
  bool is_filling = false;
};

double number_at(const ordered_json& json, const char* pointer, const std::string& path) {
  const ordered_json::json_pointer at(pointer);
  constexpr double kAbsurd = 1e30;
  if (json.contains(at) && json[at].is_number() && std::abs(json[at].get<double>()) < kAbsurd)
    return json[at].get<double>();
  throw InputError(Complaint{path, fmt::format("has no number {} within +-1e30", pointer), kRunSummary,
                             "give a campaign of a ship; `brash resistance CASE -o FOLDER` runs one"});
}

/// @param folder  of a case of the campaign.
Run read_run(const fs::path& folder) {
  const std::string path = (folder / "summary.json").string();
  const auto json = ordered_json::parse(read_json_text(path, kRunSummary), nullptr, /*allow_exceptions=*/false);
  const auto number = [&](const char* pointer) { return number_at(json, pointer, path); };
  Run run{.resistance = number("/horizontal/mean"),
          .within = {},
          .breaking = number("/horizontal/mean_by_cause/crushing"),
          .pieces = number("/horizontal/mean_by_cause/floe_normal"),
          .friction = number("/horizontal/mean_by_cause/floe_friction"),
          .covered_bottom = 0.0,
          .statistics_from = number("/statistics_from")};
  const ordered_json::json_pointer covered("/mean_by_region/bottom/covered"), lower("/horizontal/mean_95/0");
  if (json.contains(covered)) run.covered_bottom = number("/mean_by_region/bottom/covered");
  if (json.contains(lower) && json[lower].is_number())
    run.within = {number("/horizontal/mean_95/0"), number("/horizontal/mean_95/1")};
  for (const model::Warning& warning : io::warnings_beside((folder / "history.csv").string()))
    run.is_filling = run.is_filling || warning.id == kFillingHull;
  return run;
}

/// The runs of one setting of a campaign.
struct Point {
  std::string setting;
  model::Case resolved;
  std::vector<Run> runs;

  /// The name of the case, without the setting.
  std::string ship() const { return resolved.name.substr(0, resolved.name.size() - setting.size() - 1); }
  double thickness() const { return resolved.ice.thickness; }
  double speed() const { return model::speed(resolved.structure.motion); }
  double mean(double Run::*number) const {
    double sum = 0.0;
    for (const Run& run : runs) sum += run.*number;
    return sum / static_cast<double>(runs.size());
  }
  std::optional<Interval> interval() const {
    if (runs.size() == 1) return runs.front().within;
    std::vector<double> means;
    for (const Run& run : runs) means.push_back(run.resistance);
    return statistics::mean_interval(means);
  }
  /// Why the mean cannot be called steady; "" when it can.
  std::string unsteady() const {
    const double length = *resolved.hull.length, way = speed() * runs.front().statistics_from;
    if (way < (1.0 - 1e-3) * kSteadyLengths * length)  // a plan rounds times to milliseconds
      return fmt::format("the statistics begin after {:.2g} lengths of the hull, and {:g} is the least", way / length,
                         kSteadyLengths);
    const auto n = std::ranges::count_if(runs, &Run::is_filling);
    return n == 0 ? "" : fmt::format("the bottom still gathers ice in {} of {} runs", n, runs.size());
  }
};

std::vector<Point> read_points(const std::string& campaign) {
  if (!io::is_campaign(campaign))
    throw InputError(Complaint{campaign, "is not a campaign: it has no campaign.csv", "a case file, or such a folder",
                               "`brash resistance CASE -o FOLDER` makes one"});
  std::vector<Point> points;
  for (const auto& [setting, cases] : counted_cases(campaign)) {
    const auto resolved = case_of_setting(campaign, setting);
    if (!resolved)
      throw InputError(Complaint{campaign, fmt::format("holds no case of the setting {}", setting),
                                 "the resolved cases that a campaign leaves", "run the campaign with `--resume`"});
    Point point{setting, *resolved, {}};
    if (!point.resolved.hull.length)
      throw InputError(Complaint{campaign, "is of a structure without [hull] length", "a campaign of a ship",
                                 "`brash resistance CASE -o FOLDER` makes one"});
    for (const std::string& name : cases) point.runs.push_back(read_run(fs::path(campaign) / "cases" / name));
    points.push_back(std::move(point));
  }
  if (points.empty())
    throw InputError(Complaint{campaign, "has no case that is done", "a campaign with finished cases",
                               "continue with `--resume`; its failed cases say why they failed"});
  std::ranges::sort(points, {}, [](const Point& p) { return std::pair(p.thickness(), p.speed()); });
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i].thickness() == points[i - 1].thickness() && points[i].speed() == points[i - 1].speed())
      throw InputError(Complaint{campaign,
                                 fmt::format("has two settings of one thickness and speed, {} and {}",
                                             points[i - 1].setting, points[i].setting),
                                 "a grid of ice.thickness and structure.speed alone",
                                 "take a campaign of one ship in one ice"});
  return points;
}

ordered_json json_of(const std::optional<Interval>& interval) {
  return interval ? ordered_json{interval->lower, interval->upper} : ordered_json();
}

template <typename Load>
ordered_json closed_form(const std::optional<tl::expected<Load, standards::NotApplicable>>& load) {
  return load && *load ? ordered_json((*load)->total) : ordered_json();
}

ordered_json point_json(const Point& point) {
  ordered_json out{{"setting", point.setting},
                   {"thickness", point.thickness()},
                   {"speed", point.speed()},
                   {"runs", point.runs.size()},
                   {"resistance", point.mean(&Run::resistance)},
                   {"resistance_95", json_of(point.interval())},
                   {"breaking", point.mean(&Run::breaking)},
                   {"pieces", point.mean(&Run::pieces)},
                   {"friction", point.mean(&Run::friction)},
                   {"covered_bottom", point.mean(&Run::covered_bottom)},
                   {"lindqvist", closed_form(lindqvist_of(point.resolved))},
                   {"riska", closed_form(riska_of(point.resolved))},
                   {"jeong", closed_form(jeong_of(point.resolved))}};
  const std::string unsteady = point.unsteady();
  out["steady"] = unsteady.empty();
  if (!unsteady.empty()) out["reason"] = unsteady;
  return out;
}

ordered_json law_json(const std::vector<Point>& points) {
  std::vector<double> thicknesses, speeds, resistances;
  for (const Point& point : points)
    for (const Run& run : point.runs) {
      if (!(run.resistance > 0.0) || !(point.speed() > 0.0)) continue;
      thicknesses.push_back(point.thickness());
      speeds.push_back(point.speed());
      resistances.push_back(run.resistance);
    }
  const auto law = statistics::fit_power_law({thicknesses, speeds}, resistances);
  if (!law) return {{"refused", "two thicknesses, two speeds and four runs are the least"}};
  return {{"runs", resistances.size()},
          {"k", estimate_json(law->factor)},
          {"b", estimate_json(law->powers[0])},
          {"n", estimate_json(law->powers[1])},
          {"spread", law->spread}};
}

/// A resistance over one input, speed or thickness, by straight lines between points.
struct Curve {
  std::vector<double> at, mean, lower, upper;  ///< rising in `at`; without intervals, both ends are NaN

  static Curve over(std::span<const Point> points, const std::function<double(const Point&)>& input) {
    Curve curve;
    for (const Point& point : points) {
      const Interval interval = point.interval().value_or(Interval{NAN, NAN});
      curve.add(input(point), point.mean(&Run::resistance), interval.lower, interval.upper);
    }
    return curve;
  }
  void add(double where, double value, double from, double to) {
    at.push_back(where);
    mean.push_back(value);
    lower.push_back(from);
    upper.push_back(to);
  }
  bool reaches(double where) const { return !at.empty() && where >= at.front() && where <= at.back(); }
  double value(const std::vector<double>& of, double where) const {
    const auto next = std::ranges::lower_bound(at, where) - at.begin();
    const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, next));
    if (at.size() == 1) return of.front();
    return std::lerp(of[i - 1], of[i], (where - at[i - 1]) / (at[i] - at[i - 1]));
  }
};

/// Where a force that is left over, rising or falling, was last above zero before it fell below.
struct Crossing {
  std::optional<double> at;
  std::string reason;  ///< why there is none
};

/// @param left_over  force at x; NaN where it is not known.
Crossing last_crossing(double first, double last, const std::function<double(double)>& left_over) {
  constexpr int kParts = 400, kHalvings = 60;
  const auto place = [&](int i) { return std::lerp(first, last, static_cast<double>(i) / kParts); };
  if (left_over(last) >= 0.0) return {{}, "above"};
  for (int i = kParts - 1; i >= 0; --i) {
    const double value = left_over(place(i));
    if (std::isnan(value)) return {{}, "unknown"};
    if (value < 0.0) continue;
    double below = place(i), above = place(i + 1);
    for (int n = 0; n < kHalvings; ++n) {
      const double middle = 0.5 * (below + above);
      (left_over(middle) < 0.0 ? above : below) = middle;
    }
    return {below, ""};
  }
  return {{}, std::isnan(left_over(last)) ? "unknown" : "below"};
}

/// Where the thrust equals a resistance, and its interval from the ends of the resistance's.
ordered_json balance(const Curve& curve, const std::function<std::optional<double>(double)>& thrust,
                     const std::string& name) {
  const auto crossing = [&](const std::vector<double>& resistance) {
    return last_crossing(curve.at.front(), curve.at.back(),
                         [&](double x) { return thrust(x).value_or(NAN) - curve.value(resistance, x); });
  };
  const auto end = [&](const std::vector<double>& resistance) {
    const auto at = crossing(resistance).at;
    return at ? ordered_json(*at) : ordered_json();
  };
  const Crossing found = crossing(curve.mean);
  ordered_json out{{name, found.at ? ordered_json(*found.at) : ordered_json()},
                   {name + "_95", {end(curve.upper), end(curve.lower)}}};
  if (!found.at) out["outside"] = found.reason;
  return out;
}

/// The points of each thickness, in rising order of both.
std::vector<std::span<const Point>> by_thickness(const std::vector<Point>& points) {
  std::vector<std::span<const Point>> groups;
  for (std::size_t first = 0, i = 0; i < points.size(); ++i) {
    if (i + 1 < points.size() && points[i + 1].thickness() == points[first].thickness()) continue;
    groups.emplace_back(&points[first], i + 1 - first);
    first = i + 1;
  }
  return groups;
}

/// Resistances over the speed, each at one thickness.
using Curves = std::vector<std::pair<double, Curve>>;

/// The attained speed over the thickness: between two thicknesses the resistance at a speed goes by a straight line.
/// A line ends where no speed of both is attained.
ordered_json attained_lines(const Curves& curves, const NetThrust& thrust) {
  constexpr int kParts = 50;
  ordered_json lines = ordered_json::array();
  bool goes_on = false;
  for (std::size_t i = 1; i < curves.size(); ++i) {
    const Curve &of_thin = curves[i - 1].second, &of_thick = curves[i].second;
    const double first = std::max(of_thin.at.front(), of_thick.at.front());
    const double last = std::min(of_thin.at.back(), of_thick.at.back());
    goes_on = goes_on && first < last;
    for (int part = goes_on ? 1 : 0; part <= kParts && first < last; ++part) {
      const double share = static_cast<double>(part) / kParts;
      const Crossing found = last_crossing(first, last, [&](double v) {
        return thrust.at(v).value_or(NAN) -
               std::lerp(of_thin.value(of_thin.mean, v), of_thick.value(of_thick.mean, v), share);
      });
      if (found.at) {
        if (!goes_on) lines.push_back({{"thickness", ordered_json::array()}, {"speed", ordered_json::array()}});
        lines.back()["thickness"].push_back(std::lerp(curves[i - 1].first, curves[i].first, share));
        lines.back()["speed"].push_back(*found.at);
      }
      goes_on = found.at.has_value();
    }
  }
  return lines;
}

void add_balances(const std::vector<Point>& points, const NetThrust& thrust, double at_speed, ordered_json& out) {
  out["thrust"] = thrust.json();
  Curve across;
  Curves curves;
  for (const auto& group : by_thickness(points)) {
    const Curve& curve = curves.emplace_back(group.front().thickness(), Curve::over(group, &Point::speed)).second;
    ordered_json entry{{"thickness", group.front().thickness()}};
    entry.update(balance(
        curve, [&](double speed) { return thrust.at(speed); }, "speed"));
    out["attained"].push_back(std::move(entry));
    if (curve.reaches(at_speed))
      across.add(group.front().thickness(), curve.value(curve.mean, at_speed), curve.value(curve.lower, at_speed),
                 curve.value(curve.upper, at_speed));
  }
  out["attained_lines"] = attained_lines(curves, thrust);
  ordered_json& thickness = out["thickness_at"];
  thickness = {{"speed", at_speed}};
  if (across.at.size() < 2)
    thickness["outside"] = "fewer than two thicknesses have runs on both sides of this speed";
  else
    thickness.update(balance(
        across, [&](double) { return thrust.at(at_speed); }, "thickness"));
}

/// Adds the presets and programs behind the campaign, as its summary has them.
void add_origin_of_campaign(const std::string& campaign, ordered_json& out) {
  const std::string path = campaign + "/summary.json";
  if (!fs::exists(path)) return;
  const auto summary = ordered_json::parse(read_json_text(path, "the summary of a campaign"), nullptr, false);
  if (summary.contains("origin")) out["origin"] = summary["origin"];
}

}  // namespace

ordered_json resistance_of(const std::string& campaign, const std::optional<NetThrust>& thrust, double at_speed) {
  const std::vector<Point> points = read_points(campaign);
  ordered_json out{{"case", points.front().ship()}, {"points", ordered_json::array()}};
  for (const Point& point : points) out["points"].push_back(point_json(point));
  add_origin_of_campaign(campaign, out);
  out["fit"] = law_json(points);
  if (thrust) add_balances(points, *thrust, at_speed, out);
  return out;
}

}  // namespace brash::analysis
