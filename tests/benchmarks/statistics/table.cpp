// SPDX-License-Identifier: GPL-3.0-or-later
#include "table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <limits>

namespace brash::coverage {

void Table::add(const std::string& process, const std::string& statistic, const statistics::Interval& interval,
                double truth, Warned warned) {
  Tally& tally = tallies_[{statistic, process, warned}];
  ++tally.n;
  tally.below += truth < interval.lower ? 1 : 0;
  tally.above += truth > interval.upper ? 1 : 0;
}

void Table::add(const std::string& process, const std::string& statistic, const nlohmann::ordered_json& ends,
                double truth, Warned warned) {
  if (ends[0].is_null()) return;
  const double upper = ends[1].is_null() ? std::numeric_limits<double>::infinity() : ends[1].get<double>();
  add(process, statistic, statistics::Interval{ends[0].get<double>(), upper}, truth, warned);
}

void Table::print() const {
  fmt::print("statistic,process,warned,held,truth_below,truth_above,n\n");
  for (const auto& [key, tally] : tallies_) {
    const auto& [statistic, process, warned] = key;
    const auto share = [&tally = tally](int count) { return static_cast<double>(count) / tally.n; };
    fmt::print("{},{},{},{:.3f},{:.3f},{:.3f},{}\n", statistic, process, warned == Warned::kYes ? "yes" : "no",
               share(tally.n - tally.below - tally.above), share(tally.below), share(tally.above), tally.n);
  }
}

int Table::report_defects() const {
  constexpr double kLeast = 0.9, kErrors = 3.0;
  int defects = 0;
  for (const auto& [key, tally] : tallies_) {
    const auto& [statistic, process, warned] = key;
    const double held = 1.0 - static_cast<double>(tally.below + tally.above) / tally.n;
    const double error = std::sqrt(kLeast * (1.0 - kLeast) / tally.n);
    if (warned == Warned::kYes || held >= kLeast - kErrors * error) continue;
    fmt::print(stderr, "{} of {}: {:.1f} % of {} intervals hold the truth\n", statistic, process, 100.0 * held,
               tally.n);
    ++defects;
  }
  return defects;
}

}  // namespace brash::coverage
