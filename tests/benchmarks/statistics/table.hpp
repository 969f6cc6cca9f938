// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>

#include "brash/statistics/summary.hpp"

namespace brash::coverage {

/// Whether the program prints a warning with an interval.
enum class Warned { kNo, kYes };

/// How often intervals held the truth, by process and statistic.
class Table {
 public:
  void add(const std::string& process, const std::string& statistic, const statistics::Interval& interval, double truth,
           Warned warned = Warned::kNo);
  /// Ends as in JSON: an upper end of null is infinite. Nothing is counted without a lower end.
  void add(const std::string& process, const std::string& statistic, const nlohmann::ordered_json& ends, double truth,
           Warned warned = Warned::kNo);

  /// Rows statistic,process,warned,held,truth_below,truth_above,n: shares of n.
  void print() const;
  /// Names the intervals without a warning that hold the truth in fewer than 90 % by more than three errors of the
  /// share; returns how many.
  int report_defects() const;

 private:
  struct Tally {
    int below = 0, above = 0, n = 0;
  };
  std::map<std::tuple<std::string, std::string, Warned>, Tally> tallies_;
};

}  // namespace brash::coverage
