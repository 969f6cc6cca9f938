// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/analysis/design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "brash/analysis/history_statistics.hpp"
#include "brash/analysis/tables.hpp"
#include "brash/core/error.hpp"
#include "brash/core/text.hpp"
#include "brash/statistics/summary.hpp"

namespace brash::analysis {
namespace {

using nlohmann::ordered_json;
using namespace statistics;

constexpr double kHour = 3600.0;  // [s]

/// Extremes of the pooled replicates, for a return period.
ExtremeAnalysis pooled(const SettingHistories& setting, ExtremeSettings settings, GoodnessOfFit& goodness) {
  std::vector<ExtremeRecord> records;
  for (const LoadHistory& load : setting.replicates) {
    const double memory = autocorrelation_time(load.history, load.even).tau;
    records.push_back({&load.history, &load.even, memory, load.clipping});
  }
  ExtremeValues values = extreme_values(records, settings);
  // Whether the record can support a period is checked for each period. The law is chosen at the longest period that it
  // can support.
  if (!settings.extrapolate)
    settings.return_period = std::min(settings.return_period, kLongestPeriod * values.duration);
  return analyse_extremes(std::move(values), settings, goodness);
}

/// Why a record gets no level for a period; "" when it does.
std::string too_long(const ExtremeAnalysis& extremes, double period, bool extrapolate) {
  const double records = period / extremes.values.duration;
  if (extrapolate || records <= kLongestPeriod) return "";
  return fmt::format("{:.4g} times the {:.4g} s of all replicates, and {:g} times is the most: {:.3g} s", records,
                     extremes.values.duration, kLongestPeriod, period / kLongestPeriod);
}

ordered_json level_json(const ExtremeAnalysis& extremes, double hours, bool extrapolate) {
  const double period = kHour * hours;
  ordered_json out{{"hours", hours}, {"records", period / extremes.values.duration}};
  const std::string refusal = extremes.recommended ? too_long(extremes, period, extrapolate) : extremes.reason;
  const auto level = refusal.empty() ? level_of(extremes.of(*extremes.recommended), period) : std::nullopt;
  if (level) {
    out["level"] = level->value;
    out["level_95"] = {level->interval.lower, level->interval.upper};
  } else {
    out["refused"] = refusal.empty() ? "the exposure is shorter than a block" : refusal;
  }
  return out;
}

ordered_json state_json(const DesignState& state, const DesignSettings& asked) {
  const ExtremeAnalysis& e = state.extremes;
  ordered_json out{{"setting", state.setting->name},
                   {"values", state.setting->values},
                   {"replicates", state.setting->replicates.size()},
                   {"duration", e.values.duration},
                   {"load_events", e.values.n_events}};
  if (!asked.scatter.empty()) out["hours_a_year"] = state.hours;
  ordered_json levels = ordered_json::array();
  for (const double hours : asked.hours) levels.push_back(level_json(e, hours, asked.extremes.extrapolate));
  out["levels"] = std::move(levels);
  out["law"] = e.recommended ? ordered_json(name_of(*e.recommended)) : ordered_json();
  out["reason"] = e.reason;
  std::vector<const LoadHistory*> loads;
  for (const LoadHistory& load : state.setting->replicates) loads.push_back(&load);
  out["fatigue"] = fatigue_json(loads, asked.exponents, e.values.block, asked.frequency);
  out["warnings"] = ordered_json::array();
  if (e.values.acts_downwards) out["warnings"].push_back(kNegativeMean);
  if (e.values.clipping) out["warnings"].push_back("a sensor seems to clip: larger loads are lost");
  if (const std::string correlated = correlation_warning(e.values); !correlated.empty())
    out["warnings"].push_back(correlated);
  for (const std::string& warning : run_warnings(state.setting->replicates)) out["warnings"].push_back(warning);
  return out;
}

/// Why there are no annual levels; "" when there are.
std::string refusal_of_years(const std::vector<DesignState>& states, const DesignSettings& asked) {
  const double rarest = *std::ranges::min_element(asked.annual);
  bool any = false;
  for (const DesignState& state : states) {
    if (state.hours == 0.0) continue;
    any = true;
    const std::string& name = state.setting->name;
    if (!state.extremes.recommended) return fmt::format("setting '{}': {}", name, state.extremes.reason);
    const std::string refusal = too_long(state.extremes, kHour * state.hours / rarest, asked.extremes.extrapolate);
    if (!refusal.empty()) return fmt::format("setting '{}': {:g} hours a year ask for {}", name, state.hours, refusal);
  }
  return any ? "" : "no state of the scatter table lasts";
}

void add_years(const DesignSettings& asked, Design& design) {
  ordered_json& out = design.json["annual"];
  if (const std::string refusal = refusal_of_years(design.states, asked); !refusal.empty()) {
    out = {{"refused", refusal}};
    return;
  }
  std::vector<IceState> states;
  for (const DesignState& state : design.states) {
    if (state.hours == 0.0) continue;
    const ExtremeEstimate& e = state.extremes.of(*state.extremes.recommended);
    states.push_back({*e.fit, e.rate, state.hours});
  }
  design.long_term.emplace(states, *std::ranges::min_element(asked.annual));
  out = ordered_json::array();
  for (const double probability : asked.annual) {
    const Estimate level = design.long_term->level(probability);
    const std::vector<double> parts = design.long_term->shares(level.value);
    double sum = 0.0;
    for (const double part : parts) sum += part;
    ordered_json shares = ordered_json::object();
    std::size_t next = 0;
    double records = 0.0;  // of the state that is asked for most
    for (const DesignState& state : design.states) {
      if (state.hours == 0.0) continue;
      shares[state.setting->name] = parts[next++] / sum;
      records = std::max(records, kHour * state.hours / probability / state.extremes.values.duration);
    }
    out.push_back({{"probability", probability},
                   {"return_period_years", -1.0 / std::log1p(-probability)},
                   {"records", records},
                   {"level", level.value},
                   {"level_95", {level.interval.lower, level.interval.upper}},
                   {"shares", shares}});
  }
}

/// Equivalent loads over the hours of all states; their bounds add the bounds of the states, which is wide.
ordered_json fatigue_of_years(const ordered_json& settings, const DesignSettings& asked) {
  ordered_json out = ordered_json::array();
  for (std::size_t i = 0; i < asked.exponents.size(); ++i) {
    const double m = asked.exponents[i];
    double hours = 0.0, sum = 0.0, lower = 0.0, upper = 0.0;
    for (const ordered_json& state : settings) {
      const double h = state["hours_a_year"].get<double>();
      if (h == 0.0) continue;
      const ordered_json &f = state["fatigue"][i], &ends = f["equivalent_load_95"];
      const auto part = [&](const ordered_json& load) {
        return load.is_null() ? INFINITY : h * std::pow(load.get<double>(), m);
      };
      hours += h;
      sum += part(f["equivalent_load"]);
      lower += part(ends[0]);
      upper += part(ends[1]);
    }
    if (hours == 0.0) continue;
    // A state without an end leaves all states without it.
    const auto range = [&](double damage) -> ordered_json {
      return std::isfinite(damage) ? ordered_json(std::pow(damage / hours, 1.0 / m)) : nullptr;
    };
    ordered_json entry{{"exponent", m}, {"frequency", asked.frequency}, {"equivalent_load", range(sum)}};
    entry["equivalent_load_95"] = {range(lower), range(upper)};
    out.push_back(entry);
  }
  return out;
}

double longest_period(const DesignSettings& asked, double hours_a_year) {
  double longest = kHour * *std::ranges::max_element(asked.hours);
  if (hours_a_year > 0.0) longest = std::max(longest, kHour * hours_a_year / *std::ranges::min_element(asked.annual));
  return longest;
}

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

Design design_of(const std::vector<SettingHistories>& settings, const DesignSettings& asked) {
  Design design;
  design.unit = settings.front().replicates.front().unit;
  const std::vector<double> hours =
      asked.scatter.empty() ? std::vector<double>(settings.size(), 0.0) : read_scatter(asked.scatter, settings);
  design.json = {{"column", settings.front().replicates.front().column},
                 {"unit", design.unit.empty() ? ordered_json() : ordered_json(design.unit)},
                 {"settings", ordered_json::array()}};
  model::Origin origin;
  for (const SettingHistories& setting : settings) model::add(origin, origin_of(setting.replicates));
  add_origin(origin, design.json);
  GoodnessOfFit goodness;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    ExtremeSettings extremes = asked.extremes;
    extremes.return_period = longest_period(asked, hours[i]);
    design.states.push_back({&settings[i], pooled(settings[i], extremes, goodness), hours[i]});
    design.json["settings"].push_back(state_json(design.states.back(), asked));
  }
  if (asked.scatter.empty()) return design;
  add_years(asked, design);
  design.json["fatigue"] = fatigue_of_years(design.json["settings"], asked);
  return design;
}

std::string design_text(const ordered_json& design) {
  const std::string unit =
      design["unit"].is_null() ? "" : fmt::format(" [{}]", printable(design["unit"].get<std::string>()));
  std::string text = fmt::format("{}{}\n", design["column"].get<std::string>(), unit) + origin_text(design);
  for (const ordered_json& state : design["settings"]) text += state_text(state);
  if (design.contains("annual")) text += years_text(design["annual"]);
  if (design.contains("fatigue")) text += fatigue_text(design["fatigue"]);
  return text;
}

}  // namespace brash::analysis
