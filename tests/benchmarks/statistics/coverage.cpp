// SPDX-License-Identifier: GPL-3.0-or-later
// How often the nominal 95 % intervals of load statistics hold the truth, on simulated sawtooth loads.
//
//   bench_coverage [SHARE [STUDY]]
//
// prints a table; coverage.csv keeps it. SHARE of the full number of records, 1 by default. STUDY is one
// of the names below. The program fails if an interval without a warning holds the truth in fewer than 90 %.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "studies.hpp"

int main(int argc, char** argv) {
  using namespace brash::coverage;
  struct Study {
    std::string_view name;
    int records;  // of the full study, which takes a core about a quarter of an hour
    void (*run)(const Process&, int, Table&);
  };
  constexpr Study kStudies[]{{"history", 5000, study_history},    {"slow", 1000, study_slow_change},
                             {"bootstrap", 200, study_bootstrap}, {"extremes", 5000, study_extremes},
                             {"fatigue", 1000, study_fatigue},    {"comparison", 2000, study_comparison},
                             {"trend", 2000, study_trend},        {"design", 200, study_design}};
  const double share = argc > 1 ? std::atof(argv[1]) : 1.0;
  Table table;
  for (const Study& study : kStudies) {
    if (argc > 2 && study.name != argv[2]) continue;
    for (const Process& process : processes())
      study.run(process, std::max(1, static_cast<int>(std::lround(share * study.records))), table);
  }
  table.print();
  return table.report_defects() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
