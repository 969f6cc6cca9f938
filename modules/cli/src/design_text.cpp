// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "brash/core/text.hpp"
#include "brash/statistics/extreme_analysis.hpp"
#include "design.hpp"
#include "extreme_statistics.hpp"
#include "fatigue_statistics.hpp"
#include "origin_text.hpp"

namespace brash::cli {
namespace {

using nlohmann::ordered_json;

/// The warning of a level that is far beyond the record; "" where it is not.
std::string mark(const ordered_json& level) {
  const double records = level["records"].get<double>();
  if (records <= statistics::kMarkedPeriod) return "";
  return fmt::format("    warning: {:.3g} times the record: the level rests on the law more than on data\n", records);
}

std::string level_text(const ordered_json& level) {
  const double hours = level["hours"].get<double>();
  if (level.contains("refused"))
    return fmt::format("  once in {:g} h: no level: {}\n", hours, level["refused"].get<std::string>());
  std::string text = fmt::format("  once in {:g} h: {:.6g}   95 % interval {}\n", hours, level["level"].get<double>(),
                                 ends_text(level["level_95"]));
  return text + mark(level);
}

std::string state_text(const ordered_json& s) {
  std::string text =
      fmt::format("{}: {} replicates, {:.6g} s, {} load events", s["setting"].get<std::string>(),
                  s["replicates"].get<std::size_t>(), s["duration"].get<double>(), s["load_events"].get<std::size_t>());
  if (s.contains("hours_a_year")) text += fmt::format(", {:g} hours a year", s["hours_a_year"].get<double>());
  text += '\n';
  for (const ordered_json& level : s["levels"]) text += level_text(level);
  if (!s["law"].is_null())
    text += fmt::format("  by {}: {}\n", s["law"].get<std::string>(), s["reason"].get<std::string>());
  text += fatigue_text(s["fatigue"]);
  for (const ordered_json& warning : s["warnings"]) text += fmt::format("  warning: {}\n", warning.get<std::string>());
  return text;
}

std::string years_text(const ordered_json& annual) {
  if (annual.is_object()) return fmt::format("all states: no annual level: {}\n", annual["refused"].get<std::string>());
  std::string text = "all states of the scatter table\n";
  for (const ordered_json& a : annual) {
    text += fmt::format("  annual probability {:g} ({:.4g} years): {:.6g}   95 % interval {}\n",
                        a["probability"].get<double>(), a["return_period_years"].get<double>(),
                        a["level"].get<double>(), ends_text(a["level_95"]));
    std::string largest;
    double share = 0.0;
    for (const auto& [name, value] : a["shares"].items())
      if (value.get<double>() > share) largest = name, share = value.get<double>();
    text += fmt::format("    {:.0f} % of it from {}\n", 100.0 * share, largest) + mark(a);
  }
  return text;
}

}  // namespace

std::string design_text(const ordered_json& design) {
  const std::string unit =
      design["unit"].is_null() ? "" : fmt::format(" [{}]", printable(design["unit"].get<std::string>()));
  std::string text = fmt::format("{}{}\n", design["column"].get<std::string>(), unit) + origin_text(design);
  for (const ordered_json& state : design["settings"]) text += state_text(state);
  if (design.contains("annual")) text += years_text(design["annual"]);
  if (design.contains("fatigue")) text += fatigue_text(design["fatigue"]);
  return text;
}

}  // namespace brash::cli
