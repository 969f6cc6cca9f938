// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include "brash/analysis/history_comparison.hpp"
#include "brash/statistics/hypothesis.hpp"
#include "brash/statistics/intervals.hpp"
#include "brash/statistics/moments.hpp"
#include "brash/statistics/quantile.hpp"
#include "studies.hpp"

namespace brash::coverage {
namespace {

using namespace statistics;

std::vector<analysis::LoadHistory> records_of(const Process& process, int records, int cycles, RandomStream& stream) {
  std::vector<analysis::LoadHistory> loads;
  for (int i = 0; i < records; ++i) loads.push_back(record(process, cycles, stream));
  return loads;
}

/// A share of verdicts counts like a share of intervals.
void add_verdict(const std::string& process, const std::string& name, bool right, Table& table) {
  table.add(process, name, Interval{0.0, 0.0}, right ? 0.0 : 1.0);
}

void compare(const Process& process, const std::string& sides, int histories, int cycles, RandomStream& stream,
             Table& table) {
  const auto a = records_of(process, histories, cycles, stream), b = records_of(process, histories, cycles, stream);
  const auto found = analysis::compare_histories(a, b);
  table.add(process.name, "compare " + sides + ": difference of means", found["mean"]["difference_95"], 0.0);
  for (const char* name : {"mean", "deviation", "mean_peak", "peak_rate"})
    if (found.contains(name) && found[name].contains("ratio_95"))
      table.add(process.name, fmt::format("compare {}: ratio of {}", sides, name), found[name]["ratio_95"], 1.0);
  if (!found["differs"].is_null())
    add_verdict(process.name, "compare " + sides + ": no difference found", found["differs"].empty(), table);
}

/// Settings of a grid whose replicates are all of one process.
void look_for_trend(const Process& process, std::size_t replicates, double truth, RandomStream& stream, Table& table) {
  constexpr int kSettings = 3, kCycles = 30;
  std::vector<std::vector<double>> means(kSettings), high(kSettings);
  for (int s = 0; s < kSettings; ++s)
    for (std::size_t r = 0; r < replicates; ++r) {
      const analysis::LoadHistory load = record(process, kCycles, stream);
      means[static_cast<std::size_t>(s)].push_back(moments(load.history.values).mean);
      high[static_cast<std::size_t>(s)].push_back(quantiles(load.history.values, std::array{0.99})[0]);
    }
  const std::string of = fmt::format("trend of {} replicates: ", replicates);
  table.add(process.name, of + "mean of a setting", mean_interval(means.front()), truth);
  for (const auto& [name, groups] : {std::pair{"mean", &means}, std::pair{"99 % load", &high}}) {
    const Interval ends = compare_means({PairOfGroups{groups->back(), groups->front()}}).interval;
    table.add(process.name, fmt::format("{}last less first of the {}", of, name), ends, 0.0);
    const bool none = jonckheere_terpstra(*groups).p_value >= 0.05 && ends.lower <= 0.0 && ends.upper >= 0.0;
    add_verdict(process.name, fmt::format("{}undecided on the {}", of, name), none, table);
  }
}

}  // namespace

void study_comparison(const Process& process, int records, Table& table) {
  for (int r = 0; r < records; ++r) {
    RandomStream stream(1, process.name, static_cast<std::uint64_t>(r), "comparison");
    compare(process, "two histories", 1, 100, stream, table);
    compare(process, "4 and 4 histories", 4, 30, stream, table);
  }
}

void study_trend(const Process& process, int records, Table& table) {
  const double mean = mean_load(process);
  for (int r = 0; r < records; ++r) {
    RandomStream stream(1, process.name, static_cast<std::uint64_t>(r), "trend");
    for (const std::size_t replicates : {3, 8}) look_for_trend(process, replicates, mean, stream, table);
  }
}

}  // namespace brash::coverage
