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
#include "brash/core/text.hpp"
#include "brash/statistics/summary.hpp"

namespace brash::analysis {
namespace {

using nlohmann::ordered_json;
using namespace statistics;

constexpr double kHour = 3600.0;     // [s]
constexpr double kDependent = 1.5;   // dispersion of the replicates that is worth a line
constexpr double kHeavy = 0.5;       // shape from which on the variance is infinite
constexpr double kDifferent = 0.05;  // p below which the settings' shapes differ

// The convergence of IEC 61400-1:2019, Annex G: the 90 % interval of the load that 84 % of ten-minute maxima stay below
// is at most 15 % of it wide.
constexpr double kTenMinutes = 600.0, kFractile = 0.84, kFractileConfidence = 0.9, kWidest = 0.15;

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
          {"converged", width <= kWidest}};
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

/// Warnings of the levels of a table.
std::string notes_text(const ordered_json& levels, double most) {
  bool far = false, above = false;
  for (const ordered_json& level : levels) {
    if (!level.contains("level")) continue;
    far = far || level["records"].get<double>() > kMarkedPeriod;
    above = above || level["level"] > most;
  }
  std::string text;
  if (far)
    text += fmt::format("  warning: beyond {:g} times the histories a level rests on the law more than on data\n",
                        kMarkedPeriod);
  if (above) text += "  warning: above crushing: the ice over the full width crushes at less\n";
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
                     c["converged"].get<bool>() ? "within" : "and should be to", 100.0 * kWidest);
}

std::string state_text(const ordered_json& s, const TableUnit& unit) {
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
  text += notes_text(s["levels"], most);
  text += convergence_text(s) + forms_text(s, unit) + fatigue_text(s["fatigue"], unit);
  for (const ordered_json& warning : s["warnings"]) text += fmt::format("  warning: {}\n", warning.get<std::string>());
  return text;
}

std::string years_text(const ordered_json& design, const TableUnit& unit) {
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
  text += notes_text(annual, most);
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

std::string design_text(const ordered_json& design) {
  const TableUnit unit = unit_of(design);
  const std::string si =
      design["unit"].is_null() ? "" : fmt::format(" [{}]", printable(design["unit"].get<std::string>()));
  std::string text = design["column"].get<std::string>() + si + "\n" + origin_text(design) + tail_text(design);
  if (design.contains("annual")) text += years_text(design, unit);
  if (design.contains("fatigue")) text += fatigue_text(design["fatigue"], unit);
  for (const ordered_json& state : design["settings"]) text += state_text(state, unit);
  return text;
}

}  // namespace brash::analysis
