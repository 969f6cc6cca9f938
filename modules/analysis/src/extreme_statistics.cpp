// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "brash/analysis/history_statistics.hpp"

namespace brash::analysis {
namespace {

using nlohmann::ordered_json;
using statistics::ExtremeAnalysis;
using statistics::ExtremeEstimate;
using statistics::Law;

void add_level(const ExtremeEstimate& e, ordered_json& out) {
  if (e.level) {
    out["level"] = e.level->value;
    out["level_95"] = {e.level->interval.lower, e.level->interval.upper};
  } else {
    out["not_fitted"] = e.refusal;
  }
}

ordered_json law_json(const ExtremeEstimate& e) {
  ordered_json out{{"law", statistics::name_of(e.law)}};
  if (e.fit) {
    const statistics::Distribution& d = e.fit->distribution;
    out["values"] = e.fit->values.size();
    out["location"] = d.location;
    out["scale"] = d.scale;
    out["shape"] = d.shape;
    out["anderson_darling"] = {{"statistic", e.goodness.statistic}, {"p", e.goodness.p_value}};
  }
  add_level(e, out);
  return out;
}

ordered_json pareto_json(const ExtremeAnalysis& analysis) {
  const statistics::ExtremeValues& v = analysis.values;
  ordered_json out{{"threshold", v.threshold},
                   {"separation", v.separation},
                   {"peaks", v.over.size()},
                   {"return_period", analysis.return_period}};
  const ExtremeEstimate& e = analysis.of(Law::kPareto);
  if (e.fit) {
    out["scale"] = e.fit->distribution.scale;
    out["shape"] = e.fit->distribution.shape;
  }
  add_level(e, out);
  return out;
}

ordered_json gumbel_json(const ExtremeAnalysis& analysis) {
  const statistics::ExtremeValues& v = analysis.values;
  ordered_json out{{"block", v.block}, {"blocks", v.maxima.size()}, {"return_period", analysis.return_period}};
  const ExtremeEstimate& e = analysis.of(Law::kGumbel);
  if (e.fit) {
    out["location"] = e.fit->distribution.location;
    out["scale"] = e.fit->distribution.scale;
  }
  add_level(e, out);
  return out;
}

std::string values_text(const ordered_json& s, const std::string& law) {
  if (law == "Gumbel" || law == "GEV")
    return fmt::format("blocks of {:.4g} s", s["block_maxima"]["block"].get<double>());
  if (law == "Pareto") return fmt::format("peaks above {:.6g}", s["extremes"]["threshold"].get<double>());
  return "peaks above the mean";
}

std::string law_text(const ordered_json& s, const ordered_json& law) {
  const std::string name = law["law"].get<std::string>();
  if (!law.contains("level"))
    return fmt::format("    {:<18} unknown: {}\n", name, law["not_fitted"].get<std::string>());
  return fmt::format("    {:<18} {:.6g}   95 % interval {}, {} {}, p = {:.2f}\n", name, law["level"].get<double>(),
                     ends_text(law["level_95"]), law["values"].get<std::size_t>(), values_text(s, name),
                     law["anderson_darling"]["p"].get<double>());
}

}  // namespace

void add_extremes(const ExtremeAnalysis& analysis, ordered_json& out) {
  out["extremes"] = pareto_json(analysis);
  out["block_maxima"] = gumbel_json(analysis);
  out["laws"] = ordered_json::array();
  for (const ExtremeEstimate& e : analysis.estimates) out["laws"].push_back(law_json(e));
  out["recommended"] = {{"law", nullptr}, {"reason", analysis.reason}};
  if (analysis.recommended) {
    const ExtremeEstimate& e = analysis.of(*analysis.recommended);
    out["recommended"]["law"] = statistics::name_of(e.law);
    add_level(e, out["recommended"]);
  }
  if (!out.contains("warnings")) out["warnings"] = ordered_json::array();
  for (const std::string& warning : analysis.warnings) out["warnings"].push_back(warning);
}

std::string ends_text(const ordered_json& ends, double one) {
  const bool open = ends[1].is_null() || !std::isfinite(ends[1].get<double>());
  return fmt::format("[{:.6g}, {}]", ends[0].get<double>() / one,
                     open ? "no upper end" : fmt::format("{:.6g}", ends[1].get<double>() / one));
}

std::string extremes_text(const ordered_json& s) {
  std::string text = fmt::format("  once in {:.6g} s\n", s["extremes"]["return_period"].get<double>());
  bool any = false;
  for (const ordered_json& law : s["laws"]) any = any || law.contains("level");
  for (const ordered_json& law : s["laws"])
    if (any) text += law_text(s, law);
  const ordered_json& chosen = s["recommended"];
  const auto reason = chosen["reason"].get<std::string>();
  if (chosen["law"].is_null()) return text + fmt::format("    no level recommended: {}\n", reason);
  text += fmt::format("    recommended        {:.6g}   {} by {}: {}\n", chosen["level"].get<double>(),
                      ends_text(chosen["level_95"]), chosen["law"].get<std::string>(), reason);
  return text + "    Gumbel, Weibull and Rayleigh fix the shape of the tail: their intervals hold if it is right\n";
}

}  // namespace brash::analysis
