// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "brash/analysis/design.hpp"
#include "brash/statistics/random.hpp"
#include "studies.hpp"

namespace brash::coverage {
namespace {

using namespace statistics;

constexpr int kReplicates = 6, kCycles = 40;
constexpr double kHour = 3600.0;   // [s]
constexpr double kAnnual = 0.1;    // probability that is asked for
constexpr double kYears = 5e4;     // return period that is asked for: some 1e5 times the histories of a state
constexpr double kExponent = 5.0;  // of equivalent loads
constexpr double kExposure = 2.0;  // [h], 30 times the replicates of a state
/// Loads of the three states, as factors, and the hours that they last a year.
constexpr std::array<double, 3> kScales{0.8, 1.0, 1.25}, kHours{0.15, 0.1, 0.05};

/// Probability that a value is exceeded, from the level that a probability exceeds.
double exceedance(const Process& process, double level) {
  double low = -60.0, high = 0.0;  // logarithm
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (process.peak(std::exp(middle)) > level ? low : high) = middle;
  }
  return std::exp(high);
}

double level_of_years(const Process& process, double cycle, double years) {
  double low = 0.0, high = 1e5;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    double expected = 0.0;
    for (std::size_t s = 0; s < kScales.size(); ++s)
      expected += kHour * kHours[s] / cycle * exceedance(process, middle / kScales[s]);
    (expected > 1.0 / years ? low : high) = middle;
  }
  return high;
}

/// Equivalent load of all states.
double equivalent_load(const Process& process, double cycle) {
  double sum = 0.0, hours = 0.0;
  for (std::size_t s = 0; s < kScales.size(); ++s) {
    sum += kHours[s] * std::pow(kScales[s], kExponent);
    hours += kHours[s];
  }
  return std::pow(damage_of_cycle(process, kExponent) / cycle * sum / hours, 1.0 / kExponent);
}

std::vector<analysis::SettingHistories> campaign(const Process& process, RandomStream& stream) {
  std::vector<analysis::SettingHistories> settings;
  for (std::size_t s = 0; s < kScales.size(); ++s) {
    settings.push_back({fmt::format("state-{}", s), {{"ice.thickness", kScales[s]}}, {}, {}});
    for (int r = 0; r < kReplicates; ++r)
      settings.back().replicates.push_back(record(process, kCycles, stream, kScales[s]));
  }
  return settings;
}

}  // namespace

void study_design(const Process& process, int records, Table& table) {
  const double cycle = mean_cycle();
  const double load = equivalent_load(process, cycle);
  analysis::DesignSettings asked;
  asked.hours = {kExposure};
  asked.years = {analysis::years_of(kAnnual), kYears};
  asked.exponents = {kExponent};
  asked.hours_a_year.assign(kHours.begin(), kHours.end());
  for (int r = 0; r < records; ++r) {
    RandomStream stream(1, process.name, static_cast<std::uint64_t>(r), "design");
    const auto settings = campaign(process, stream);
    const auto found = analysis::design_of(settings, asked).json;
    for (std::size_t s = 0; s < kScales.size(); ++s) {
      const auto& state = found["settings"][s];
      if (const auto& exposed = state["levels"][0]; exposed.contains("level_95"))
        table.add(process.name, "design: level of an exposure", exposed["level_95"],
                  kScales[s] * process.peak(cycle / (kHour * kExposure)));
    }
    if (!found["annual"].is_array()) continue;
    for (const auto& annual : found["annual"]) {
      const double years = annual["years"];
      const double truth = level_of_years(process, cycle, years);
      const bool far = years > kYears / 2.0;
      table.add(process.name, far ? "design: level far beyond the histories" : "design: annual level of three states",
                annual["level_95"], truth);
    }
    table.add(process.name, "design: equivalent load of three states", found["fatigue"][0]["equivalent_load_95"], load);
  }
}

}  // namespace brash::coverage
