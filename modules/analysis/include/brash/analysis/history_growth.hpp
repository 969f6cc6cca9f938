// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "brash/analysis/load_history.hpp"

namespace brash::analysis {

/// How fast the ice passes the structure on both sides of a comparison [m/s]; both 0: not known.
struct IceSpeeds {
  double run = 0.0;
  double measured = 0.0;
};

/// How the loads of two sides grow with the ice that has come.
///
/// Both are counted from their start over the travel that all have: speed times time, or the time alone without speeds.
/// `windows` has the means of quarters of it, with their 95 % intervals. The growth of a side is the mean of the second
/// half over the mean of the first, and `ratio` the growth of the run over the growth of the measurement, with
/// `ratio_95` and the p-value of equality. The growth of several replicates has its error from their spread.
///
/// @param runs, measured  histories of each side, at least one each.
/// @return null if a half has fewer than 20 samples or no positive mean. A window with fewer has a null mean.
nlohmann::ordered_json compare_growth(const std::vector<LoadHistory>& runs, const std::vector<LoadHistory>& measured,
                                      const IceSpeeds& speeds);

}  // namespace brash::analysis
