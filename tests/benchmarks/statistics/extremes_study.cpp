// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "brash/analysis/history_statistics.hpp"
#include "brash/statistics/extreme_analysis.hpp"
#include "studies.hpp"

namespace brash::coverage {
namespace {

using namespace statistics;

constexpr int kCycles = 100;

bool has_fixed_shape(Law law) { return law != Law::kGev && law != Law::kPareto; }

void count_levels(const Process& process, const ExtremeAnalysis& analysis, double periods, double truth, Table& table) {
  const auto add = [&](const std::string& name, const ExtremeEstimate& e, Warned warned) {
    table.add(process.name, fmt::format("{} at {:g} records", name, periods), e.level->interval, truth, warned);
  };
  for (const ExtremeEstimate& e : analysis.estimates)
    if (e.level) add(name_of(e.law), e, has_fixed_shape(e.law) ? Warned::kYes : Warned::kNo);
  if (analysis.recommended) add("recommended", analysis.of(*analysis.recommended), Warned::kNo);
}

/// The older estimates of the library, which Python has.
void count_older_levels(const Process& process, const ExtremeValues& values, double period, double truth,
                        Table& table) {
  if (const auto gumbel = fit_gumbel(values.maxima); gumbel && values.maxima.size() >= 10)
    table.add(process.name, "return_level of fit_gumbel", return_level(*gumbel, period / values.block).interval, truth,
              Warned::kYes);
  const auto pareto = fit_generalised_pareto(values.over, values.threshold);
  if (pareto)
    table.add(process.name, "return_level of fit_generalised_pareto",
              return_level(*pareto, values.duration, period).interval, truth);
}

}  // namespace

void study_extremes(const Process& process, int records, Table& table) {
  const double cycle = mean_cycle();
  GoodnessOfFit goodness;
  for (int r = 0; r < records; ++r) {
    RandomStream stream(1, process.name, static_cast<std::uint64_t>(r), "extremes");
    const analysis::LoadHistory load = record(process, kCycles, stream);
    const double memory = autocorrelation_time(load.history, load.even).tau;
    const ExtremeValues values = extreme_values({{&load.history, &load.even, memory}}, {});
    for (const double periods : {4.0, 30.0}) {
      ExtremeSettings settings;
      settings.return_period = periods * values.duration;
      const double truth = process.peak(cycle / settings.return_period);
      count_levels(process, analyse_extremes(values, settings, goodness), periods, truth, table);
      if (periods == 4.0) count_older_levels(process, values, settings.return_period, truth, table);
    }
  }
}

void study_fatigue(const Process& process, int records, Table& table) {
  const double cycle = mean_cycle();
  for (int r = 0; r < records; ++r) {
    RandomStream stream(1, process.name, static_cast<std::uint64_t>(r), "fatigue");
    const analysis::LoadHistory load = record(process, kCycles, stream);
    const double memory = autocorrelation_time(load.history, load.even).tau;
    const double stretch = extreme_values({{&load.history, &load.even, memory}}, {}).block;
    for (const auto& found : analysis::fatigue_json({&load}, {3.0, 5.0, 10.0}, stretch, 1.0)) {
      const auto m = found["exponent"].get<double>();
      const double truth = std::pow(damage_of_cycle(process, m) / cycle, 1.0 / m);
      const Warned warned =
          analysis::fatigue_text(nlohmann::ordered_json::array({found})).find("warning") != std::string::npos
              ? Warned::kYes
              : Warned::kNo;
      table.add(process.name, fmt::format("equivalent load at m = {:g}", m), found["equivalent_load_95"], truth,
                warned);
    }
  }
}

}  // namespace brash::coverage
