// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/analysis/design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "brash/analysis/case_forms.hpp"
#include "brash/analysis/closed_forms.hpp"
#include "brash/analysis/history_statistics.hpp"
#include "brash/analysis/tables.hpp"
#include "brash/statistics/summary.hpp"

namespace brash::analysis {
namespace {

using nlohmann::ordered_json;
using namespace statistics;

constexpr double kHour = 3600.0;  // [s]

// Of kWidestOfTenMinutes.
constexpr double kTenMinutes = 600.0, kFractile = 0.84, kFractileConfidence = 0.9;

DesignState state_of(const SettingHistories& setting, const ExtremeSettings& settings) {
  std::vector<ExtremeRecord> records;
  for (const LoadHistory& load : setting.replicates) {
    const double memory = autocorrelation_time(load.history, load.even).tau;
    records.push_back({&load.history, &load.even, memory, load.clipping});
  }
  return {&setting, extreme_values(records, settings), {}, 0.0};
}

/// The peaks over the threshold, by replicate.
StatePeaks peaks_of(const DesignState& state) {
  const ExtremeValues& e = state.extremes;
  StatePeaks peaks{e.threshold, {}, {}};
  auto from = e.over.begin();
  for (std::size_t r = 0; r < state.setting->replicates.size(); ++r) {
    const auto to = from + static_cast<std::ptrdiff_t>(e.over_of[r]);
    peaks.over.emplace_back(from, to);
    peaks.durations.push_back(state.setting->replicates[r].even.duration);
    from = to;
  }
  return peaks;
}

/// Why a state has no part in the tail; "" where it has one.
std::string why_no_tail(const ExtremeValues& e) {
  const std::vector<double>& over = e.over;
  if (over.size() < SharedTail::kFewestOfState)
    return fmt::format("{} of {} load events are over the threshold, too few", over.size(), e.n_events);
  return std::ranges::max(over) > std::ranges::min(over) ? "" : "all peaks over the threshold are equal";
}

/// Fits one tail to all states with enough peaks; returns why there is none, else "".
std::string fit_tail(Design& design) {
  std::vector<StatePeaks> peaks;
  for (DesignState& state : design.states) {
    if (!why_no_tail(state.extremes).empty()) continue;
    state.in_tail = peaks.size();
    peaks.push_back(peaks_of(state));
  }
  if (peaks.empty()) return "no setting has enough load events";
  auto tail = SharedTail::fit(std::move(peaks));
  if (!tail) return tail.error().reason;
  design.tail = *std::move(tail);
  return "";
}

ordered_json interval_json(const Interval& interval) { return {interval.lower, interval.upper}; }

/// A level that is asked for: its JSON grows to the answer.
struct Question {
  Exposure exposure;
  ordered_json json;
};

/// Adds the level with its interval, or why there is none.
void answer(const SharedTail& tail, Question& question) {
  const auto level = tail.level(question.exposure);
  if (level) {
    question.json["level"] = level->value;
    question.json["level_95"] = interval_json(level->interval);
  } else {
    question.json["refused"] = "the exposure is shorter than the time between peaks over the threshold";
  }
}

/// Whether the closed forms, which are of the horizontal load, stand beside a column.
bool is_horizontal(const std::string& column) { return column == "Fx" || column == "Fh"; }

/// The horizontal loads of the formulas that fit a structure.
ordered_json forms_json(const model::Case& resolved) {
  ordered_json forms = ordered_json::array();
  const ordered_json all = closed_form_loads(resolved);
  for (const ordered_json& load : all["loads"])
    if (load.contains("horizontal") && load["formula"] != "Nevel")
      forms.push_back({{"formula", load["formula"]}, {"method", load["method"]}, {"horizontal", load["horizontal"]}});
  return forms;
}

ordered_json convergence_json(const Design& design, const DesignState& state) {
  Exposure ten_minutes = design.exposure(state, kTenMinutes / kHour);
  ten_minutes.expected = -std::log(kFractile);
  const auto fractile = design.tail->level(ten_minutes, kFractileConfidence);
  if (!fractile) return nullptr;
  const double width = (fractile->interval.upper - fractile->interval.lower) / fractile->value;
  return {{"fractile_84", fractile->value},
          {"interval_90", interval_json(fractile->interval)},
          {"relative_width", width},
          {"converged", width <= kWidestOfTenMinutes}};
}

ordered_json state_json(const Design& design, const DesignState& state, const DesignSettings& asked) {
  const ExtremeValues& e = state.extremes;
  ordered_json out{{"setting", state.setting->name},
                   {"values", state.setting->values},
                   {"replicates", state.setting->replicates.size()},
                   {"duration", e.duration},
                   {"load_events", e.n_events},
                   {"largest", e.peaks.empty() ? ordered_json() : ordered_json(std::ranges::max(e.peaks))},
                   {"threshold", e.threshold},
                   {"peaks", e.over.size()}};
  if (design.tail && state.in_tail) {
    out["scale"] = design.tail->scale(*state.in_tail);
    out["ten_minutes"] = convergence_json(design, state);
  }
  if (!asked.hours_a_year.empty()) out["hours_a_year"] = state.hours_a_year;
  out["levels"] = ordered_json::array();
  std::vector<const LoadHistory*> loads;
  for (const LoadHistory& load : state.setting->replicates) loads.push_back(&load);
  out["fatigue"] = fatigue_json(loads, asked.exponents, e.shortest_block, asked.frequency);
  if (state.setting->resolved && is_horizontal(loads.front()->column)) {
    out["closed_forms"] = forms_json(*state.setting->resolved);
    out["full_crushing"] = full_crushing_of(*state.setting->resolved);
  }
  out["warnings"] = ordered_json::array();
  if (e.acts_downwards) out["warnings"].push_back(kNegativeMean);
  if (e.clipping) out["warnings"].push_back("a sensor seems to clip: larger loads are lost");
  if (const std::string correlated = correlation_warning(e); !correlated.empty()) out["warnings"].push_back(correlated);
  if (state.hours_a_year > 0.0 && !state.in_tail)
    out["warnings"].push_back(
        fmt::format("no tail: {}, so its {:g} hours a year add nothing", why_no_tail(e), state.hours_a_year));
  for (const std::string& warning : run_warnings(state.setting->replicates)) out["warnings"].push_back(warning);
  return out;
}

ordered_json tail_json(const SharedTail& tail) {
  const TestResult test = tail.one_shape();
  return {{"law", "Pareto"},
          {"peaks", tail.n_peaks()},
          {"shape", tail.shape()},
          {"shape_95", interval_json(tail.shape_interval())},
          {"dispersion", tail.dispersion()},
          {"one_shape", {{"statistic", test.statistic}, {"p", test.p_value}}}};
}

/// The largest crushing of the ice over the full width, of all states that last; nothing where a case is not known.
ordered_json full_crushing(const ordered_json& settings) {
  ordered_json most;
  for (const ordered_json& s : settings)
    if (s.contains("full_crushing") && s.value("hours_a_year", 1.0) > 0.0 &&
        (most.is_null() || s["full_crushing"] > most["horizontal"]))
      most = {{"horizontal", s["full_crushing"]}, {"setting", s["setting"]}};
  return most;
}

/// How the states share a level, and how far it reaches beyond the histories of the state that is asked for most.
void add_shares(const Design& design, Question& q) {
  const std::vector<double> parts = design.tail->shares(q.json["level"].get<double>(), q.exposure.seconds);
  double sum = 0.0, records = 0.0;
  for (const double part : parts) sum += part;
  ordered_json shares = ordered_json::object();
  for (const DesignState& state : design.states) {
    if (!state.in_tail || q.exposure.seconds[*state.in_tail] == 0.0) continue;
    shares[state.setting->name] = parts[*state.in_tail] / sum;
    records = std::max(records, q.exposure.seconds[*state.in_tail] / q.exposure.expected / state.extremes.duration);
  }
  q.json["records"] = records;
  q.json["shares"] = shares;
}

/// The levels of each state for hours of exposure.
void add_hours(const DesignSettings& asked, const std::string& refusal, Design& design) {
  for (std::size_t i = 0; i < design.states.size(); ++i) {
    const DesignState& state = design.states[i];
    std::vector<Question> questions;
    for (const double hours : asked.hours)
      questions.push_back({{}, {{"hours", hours}, {"records", state.records(hours)}}});
    if (state.in_tail && design.tail) {
      for (Question& q : questions) {
        q.exposure = design.exposure(state, q.json["hours"].get<double>());
        answer(*design.tail, q);
      }
    } else {
      const std::string why = state.in_tail ? refusal : why_no_tail(state.extremes);
      for (Question& q : questions) q.json["refused"] = why;
    }
    for (Question& q : questions) design.json["settings"][i]["levels"].push_back(std::move(q.json));
  }
}

/// The levels of return periods over all settings.
void add_years(const DesignSettings& asked, std::string refusal, Design& design) {
  ordered_json& out = design.json["annual"];
  const auto lasts = [](const DesignState& s) { return s.hours_a_year > 0.0 && s.in_tail; };
  if (refusal.empty() && std::ranges::none_of(design.states, lasts))
    refusal = "no setting with load events lasts for hours of a year";
  if (!refusal.empty()) {
    out = {{"refused", refusal}};
    return;
  }
  std::vector<Question> questions;
  for (const double years : asked.years)
    questions.push_back({design.exposure(years), {{"years", years}, {"probability", -std::expm1(-1.0 / years)}}});
  const ordered_json crushing = full_crushing(design.json["settings"]);
  out = ordered_json::array();
  for (Question& q : questions) {
    answer(*design.tail, q);
    if (q.json.contains("level")) {
      add_shares(design, q);
      q.json["above_crushing"] =
          crushing.is_null() ? ordered_json() : ordered_json(q.json["level"] > crushing["horizontal"]);
    }
    out.push_back(std::move(q.json));
  }
  if (!crushing.is_null()) design.json["full_crushing"] = crushing;
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

}  // namespace

double years_of(double annual_probability) { return -1.0 / std::log1p(-annual_probability); }

Exposure Design::exposure(const DesignState& state, double hours) const {
  Exposure exposure{std::vector<double>(tail->n_states(), 0.0), 1.0};
  exposure.seconds[*state.in_tail] = kHour * hours;
  return exposure;
}

Exposure Design::exposure(double years) const {
  Exposure exposure{std::vector<double>(tail->n_states(), 0.0), 1.0 / years};
  for (const DesignState& state : states)
    if (state.in_tail) exposure.seconds[*state.in_tail] = kHour * state.hours_a_year;
  return exposure;
}

Design design_of(const std::vector<SettingHistories>& settings, const DesignSettings& asked) {
  Design design;
  design.unit = settings.front().replicates.front().unit;
  design.json = {{"column", settings.front().replicates.front().column},
                 {"unit", design.unit.empty() ? ordered_json() : ordered_json(design.unit)}};
  model::Origin origin;
  for (const SettingHistories& setting : settings) model::add(origin, origin_of(setting.replicates));
  add_origin(origin, design.json);
  for (std::size_t i = 0; i < settings.size(); ++i) {
    design.states.push_back(state_of(settings[i], asked.extremes));
    if (!asked.hours_a_year.empty()) design.states.back().hours_a_year = asked.hours_a_year[i];
  }
  const std::string refusal = fit_tail(design);
  if (design.tail) design.json["tail"] = tail_json(*design.tail);
  design.json["settings"] = ordered_json::array();
  for (const DesignState& state : design.states) design.json["settings"].push_back(state_json(design, state, asked));
  add_hours(asked, refusal, design);
  if (asked.hours_a_year.empty()) return design;
  add_years(asked, refusal, design);
  design.json["fatigue"] = fatigue_of_years(design.json["settings"], asked);
  return design;
}

}  // namespace brash::analysis
