// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "brash/statistics/extreme_analysis.hpp"
#include "history_statistics.hpp"
#include "load_history.hpp"

namespace brash::cli {

/// A picture (SVG) of a history with its load events, and of the checks of its extremes: quantiles against the law,
/// levels against the return period, the shape against the threshold, and the spectrum.
std::string stats_picture(const LoadHistory& load, const StatisticsSettings& settings);

/// The checks of extremes alone, as charts whose upper left corner is (left, top), 1000 x 320 pixels.
std::string extremes_charts(const statistics::ExtremeAnalysis& analysis, const std::string& unit, double left,
                            double top);

}  // namespace brash::cli
