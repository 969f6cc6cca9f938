// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brash/analysis/design.hpp"
#include "brash/analysis/history_statistics.hpp"
#include "brash/analysis/load_history.hpp"
#include "brash/analysis/pieces.hpp"
#include "brash/analysis/resistance.hpp"
#include "brash/core/vec.hpp"
#include "brash/model/case.hpp"
#include "brash/model/records.hpp"
#include "brash/statistics/extreme_analysis.hpp"

namespace brash::report {

/// A picture (SVG) of a history with its load events, and of the checks of its extremes: quantiles against the law,
/// levels against the return period, the shape against the threshold, and the spectrum.
std::string stats_picture(const analysis::LoadHistory& load, const analysis::StatisticsSettings& settings);

/// The checks of extremes alone, as charts whose upper left corner is (left, top), 1000 x 320 pixels.
std::string extremes_charts(const statistics::ExtremeAnalysis& analysis, const std::string& unit, double left,
                            double top);

/// A picture (SVG) of a comparison: both histories, ratios with their intervals, distributions, spectra with their
/// bands.
/// @param comparison  of analysis::compare_histories().
std::string comparison_picture(const analysis::LoadHistory& run, const analysis::LoadHistory& measured,
                               const nlohmann::ordered_json& comparison);

/// A picture (SVG) of design loads: levels against the exposure, and against the annual probability.
std::string design_picture(const analysis::Design& design, const analysis::DesignSettings& asked);

/// A picture (SVG) of a ship's resistance over speed beside Lindqvist's and the thrust, and of the speed that the
/// thrust attains over thickness.
/// @param resistance  of analysis::resistance_of().
std::string resistance_picture(const nlohmann::ordered_json& resistance,
                               const std::optional<analysis::NetThrust>& thrust);

/// A picture (SVG) of pieces: the share of larger pieces with the fits, and the shares of number and area in smaller
/// pieces.
std::string pieces_picture(const analysis::PieceSizes& sizes, const analysis::PieceAnalysis& analysis);

/// The ice of a case at the start and the shore: outline and holes of each piece, sheet frame [m].
struct PicturedIce {
  std::vector<std::vector<std::vector<Vec2>>> sheets;
  std::vector<std::vector<std::vector<Vec2>>> floes;
  std::vector<std::vector<std::vector<Vec2>>> land;
};

/// A case before its run, as SVG: lengthwise sections of the hull at the water and the ice, its waterlines from above,
/// and the field with the way of the structure.
std::string case_picture(const model::Case& resolved, const PicturedIce& of_start);

/// The end of a run seen from above, as SVG: the land, the sheet with its channel, every floe where it floats (those
/// under the sheet's level darker), the structure at its waterline, the points where the ice broke, and a scale.
/// @param land  as in RunSource.
std::string plan_view(const model::Case& resolved, const model::RunResults& results,
                      const std::vector<std::vector<std::vector<Vec2>>>& land);

}  // namespace brash::report
