// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "brash/analysis/design.hpp"
#include "brash/core/write_file.hpp"
#include "brash/statistics/random.hpp"
#include "studies.hpp"

namespace brash::coverage {
namespace {

using namespace statistics;

constexpr int kReplicates = 6, kCycles = 40;
constexpr double kHour = 3600.0;   // [s]
constexpr double kAnnual = 0.1;    // probability that is asked for
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

double annual_level(const Process& process, double cycle) {
  double low = 0.0, high = 1e5;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    double expected = 0.0;
    for (std::size_t s = 0; s < kScales.size(); ++s)
      expected += kHour * kHours[s] / cycle * exceedance(process, middle / kScales[s]);
    (expected > -std::log1p(-kAnnual) ? low : high) = middle;
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
    settings.push_back({fmt::format("state-{}", s), {{"ice.thickness", kScales[s]}}, {}});
    for (int r = 0; r < kReplicates; ++r)
      settings.back().replicates.push_back(record(process, kCycles, stream, kScales[s]));
  }
  return settings;
}

}  // namespace

void study_design(const Process& process, int records, Table& table) {
  const double cycle = mean_cycle();
  const double level = annual_level(process, cycle), load = equivalent_load(process, cycle);
  const std::string scatter =
      (std::filesystem::temp_directory_path() / fmt::format("brash-coverage-{}.csv", ::getpid())).string();
  std::string rows = "ice.thickness,hours\n";
  for (std::size_t s = 0; s < kScales.size(); ++s) rows += fmt::format("{},{}\n", kScales[s], kHours[s]);
  write_file(scatter, rows);
  analysis::DesignSettings asked;
  asked.hours = {kExposure};
  asked.annual = {kAnnual};
  asked.exponents = {kExponent};
  asked.scatter = scatter;
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
    if (found["annual"].is_array())
      table.add(process.name, "design: annual level of three states", found["annual"][0]["level_95"], level);
    table.add(process.name, "design: equivalent load of three states", found["fatigue"][0]["equivalent_load_95"], load);
  }
  std::filesystem::remove(scatter);
}

}  // namespace brash::coverage
