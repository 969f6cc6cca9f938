// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "brash/analysis/design.hpp"
#include "brash/analysis/history_statistics.hpp"
#include "brash/analysis/tables.hpp"
#include "brash/core/text.hpp"

namespace brash::analysis {
namespace {

using nlohmann::ordered_json;
using statistics::kMarkedPeriod;

constexpr double kDependent = 1.5;   // dispersion of the replicates that is worth a line
constexpr double kHeavy = 0.5;       // shape from which on the variance is infinite
constexpr double kDifferent = 0.05;  // p below which the settings' shapes differ

std::string number_text(double value, const TableUnit& unit) {
  const double shown = value / unit.one;
  return std::abs(shown) >= 1e4 && std::abs(shown) < 1e7 ? fmt::format("{:.0f}", shown) : fmt::format("{:.4g}", shown);
}

/// @param most  no load is larger; infinite where it is not known.
std::string interval_text(const ordered_json& ends, const TableUnit& unit, double most) {
  const double lower = ends[0].get<double>(), upper = ends[1].get<double>();
  if (lower > most) return "over " + number_text(most, unit);
  return fmt::format("{} to {}{}", number_text(lower, unit), upper > most ? "over " : "",
                     number_text(std::min(upper, most), unit));
}

std::string heads_text(const char* period, const TableUnit& unit) {
  return fmt::format("  {:>12} {:>10} {:>20} {:>10}\n", period, unit.name, "95 % interval", "histories");
}

/// A line of the table; `histories` is how often the histories would have to be repeated for the period.
std::string level_text(double period, const ordered_json& level, const TableUnit& unit, double most,
                       const std::string& end) {
  if (level.contains("refused"))
    return fmt::format("  {:>12.4g} no level: {}\n", period, level["refused"].get<std::string>());
  const bool above = level["level"] > most;
  return fmt::format("  {:>12.4g} {:>10} {:>20} {:>10.2g}{}{}\n", period,
                     number_text(level["level"].get<double>(), unit), interval_text(level["level_95"], unit, most),
                     level["records"].get<double>(), end, above ? "  above crushing" : "");
}

/// A warning, and where it applies: in these words, or with other numbers.
struct Repeated {
  std::string kind, text;
  std::vector<std::string> same, others;
};
using Warnings = std::vector<Repeated>;  // in the order in which they came

/// The id of a warning of runs, "of 3 of 4 runs: short-run: ...", which has each setting's own numbers; of others the
/// text.
std::string kind_of(const std::string& warning) {
  if (!warning.starts_with("of ")) return warning;
  const std::size_t id = warning.find(": ") + 2;
  return warning.substr(id, warning.find(": ", id) - id);
}

void add_warning(const std::string& warning, const std::string& where, Warnings& warnings) {
  auto found = std::ranges::find(warnings, kind_of(warning), &Repeated::kind);
  if (found == warnings.end()) found = warnings.insert(found, {kind_of(warning), warning, {}, {}});
  (found->text == warning ? found->same : found->others).push_back(where);
}

/// Adds the warnings of the levels of a table.
void add_level_warnings(const ordered_json& levels, double most, const std::string& where, Warnings& warnings) {
  bool far = false, above = false;
  for (const ordered_json& level : levels) {
    if (!level.contains("level")) continue;
    far = far || level["records"].get<double>() > kMarkedPeriod;
    above = above || level["level"] > most;
  }
  if (far)
    add_warning(
        fmt::format("beyond {:g} times the histories a level rests on the law more than on data", kMarkedPeriod), where,
        warnings);
  if (above) add_warning("above crushing: the ice over the full width crushes at less", where, warnings);
}

std::string warnings_text(const Warnings& warnings) {
  std::string text;
  for (const Repeated& warning : warnings) {
    text += fmt::format("warning: {} ({}", warning.text, fmt::join(warning.same, ", "));
    if (!warning.others.empty()) text += fmt::format("; with other numbers {}", fmt::join(warning.others, ", "));
    text += ")\n";
  }
  return text;
}

std::string forms_text(const ordered_json& state, const TableUnit& unit) {
  if (!state.contains("closed_forms")) return "";
  std::string text = "  beside";
  for (const ordered_json& form : state["closed_forms"])
    text +=
        fmt::format(" {} {},", form["formula"].get<std::string>(), number_text(form["horizontal"].get<double>(), unit));
  return text + fmt::format(" compressive strength over the width {} {}\n",
                            number_text(state["full_crushing"].get<double>(), unit), unit.name);
}

std::string convergence_text(const ordered_json& state) {
  if (!state.contains("ten_minutes") || state["ten_minutes"].is_null()) return "";
  const ordered_json& c = state["ten_minutes"];
  return fmt::format("  IEC 61400-1: the 84 % load of ten minutes is known to {:.0f} %, {} {:.0f} %\n",
                     100.0 * c["relative_width"].get<double>(),
                     c["converged"].get<bool>() ? "within" : "and should be to", 100.0 * kWidestOfTenMinutes);
}

std::string state_text(const ordered_json& s, const TableUnit& unit, Warnings& warnings) {
  std::string text =
      fmt::format("{}: {} replicates, {:.6g} s, {} load events", s["setting"].get<std::string>(),
                  s["replicates"].get<std::size_t>(), s["duration"].get<double>(), s["load_events"].get<std::size_t>());
  if (!s["largest"].is_null())
    text += fmt::format(", the largest {} {}", number_text(s["largest"].get<double>(), unit), unit.name);
  if (s.contains("hours_a_year")) text += fmt::format(", {:g} hours a year", s["hours_a_year"].get<double>());
  text += '\n';
  const double most = s.contains("full_crushing") ? s["full_crushing"].get<double>() : INFINITY;
  text += heads_text("hours", unit);
  for (const ordered_json& level : s["levels"]) text += level_text(level["hours"].get<double>(), level, unit, most, "");
  const auto name = s["setting"].get<std::string>();
  add_level_warnings(s["levels"], most, name, warnings);
  for (const ordered_json& warning : s["warnings"]) add_warning(warning.get<std::string>(), name, warnings);
  return text + convergence_text(s) + forms_text(s, unit) + fatigue_text(s["fatigue"], unit);
}

std::string years_text(const ordered_json& design, const TableUnit& unit, Warnings& warnings) {
  const ordered_json& annual = design["annual"];
  if (annual.is_object()) return fmt::format("all settings: no level: {}\n", annual["refused"].get<std::string>());
  const double most = design.contains("full_crushing") ? design["full_crushing"]["horizontal"].get<double>() : INFINITY;
  std::string text = "all settings, by their hours a year\n" + heads_text("years", unit);
  for (const ordered_json& level : annual) {
    std::string largest;
    double share = 0.0;
    if (const auto shares = level.find("shares"); shares != level.end())
      for (const auto& [name, value] : shares->items())
        if (value.get<double>() > share) largest = name, share = value.get<double>();
    text += level_text(level["years"].get<double>(), level, unit, most,
                       largest.empty() ? "" : fmt::format("  {:.0f} % from {}", 100.0 * share, largest));
  }
  add_level_warnings(annual, most, "return periods", warnings);
  if (design.contains("full_crushing"))
    text += fmt::format("  the ice over the full width crushes at {} {} ({})\n",
                        number_text(design["full_crushing"]["horizontal"].get<double>(), unit), unit.name,
                        design["full_crushing"]["setting"].get<std::string>());
  return text;
}

std::string tail_text(const ordered_json& design) {
  if (!design.contains("tail")) return "";
  const ordered_json& tail = design["tail"];
  const double p = tail["one_shape"]["p"].get<double>();
  std::string text =
      fmt::format("Pareto's law of {} peaks, one shape: {:.2f} ({:.2f} to {:.2f})\n", tail["peaks"].get<std::size_t>(),
                  tail["shape"].get<double>(), tail["shape_95"][0].get<double>(), tail["shape_95"][1].get<double>());
  if (p < kDifferent)
    text += fmt::format("warning: the shapes of the settings differ by more than chance ({})\n", p_text(p));
  if (tail["shape"].get<double>() > kHeavy)
    text += "warning: no ice load has so heavy a tail: a few loads are of another kind than the others, look at them\n";
  if (const double dispersion = tail["dispersion"].get<double>(); dispersion > kDependent)
    text += fmt::format(
        "replicates differ more than independent peaks would: intervals allow {:.1f} times the deviance\n", dispersion);
  return text + fmt::format(
                    "four times the histories about halve the intervals: `brash campaign PLAN.toml -o DIR --resume "
                    "--replicates {}`\n",
                    4 * design["settings"][0]["replicates"].get<std::size_t>());
}

/// The unit in which the levels are printed.
TableUnit unit_of(const ordered_json& design) {
  std::vector<double> all;
  const auto add = [&](const ordered_json& levels) {
    for (const ordered_json& level : levels)
      if (level.contains("level")) all.push_back(level["level"].get<double>());
  };
  for (const ordered_json& state : design["settings"]) add(state["levels"]);
  if (design.contains("annual") && design["annual"].is_array()) add(design["annual"]);
  const std::string unit = design["unit"].is_null() ? "" : printable(design["unit"].get<std::string>());
  return unit == "N" || unit == "N m" ? unit_for(all, unit.c_str()) : TableUnit{1.0, unit};
}

}  // namespace

std::string design_text(const ordered_json& design) {
  const TableUnit unit = unit_of(design);
  const std::string si =
      design["unit"].is_null() ? "" : fmt::format(" [{}]", printable(design["unit"].get<std::string>()));
  std::string text = design["column"].get<std::string>() + si + "\n" + origin_text(design) + tail_text(design);
  Warnings warnings;
  if (design.contains("annual")) text += years_text(design, unit, warnings);
  if (design.contains("fatigue")) text += fatigue_text(design["fatigue"], unit);
  for (const ordered_json& state : design["settings"]) text += state_text(state, unit, warnings);
  return text + warnings_text(warnings);
}

}  // namespace brash::analysis
