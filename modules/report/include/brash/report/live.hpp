// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "brash/core/vec.hpp"
#include "brash/model/case.hpp"
#include "brash/model/records.hpp"

namespace brash::report {

/// What became of a floe.
struct EndedFloe {
  std::int64_t floe = 0;  ///< FloeRecord::id
  double time = 0.0;      ///< [s]
  model::FloeEnd end = model::FloeEnd::kCrushed;
};

/// The page of a run in progress. It takes what live_records() gives as events named `records`, from `events` beside
/// it.
/// @param land  its outlines, each with its holes, sheet frame [m].
/// @throws RunError in a build without the page.
std::string live_page(const model::Case& resolved, const std::vector<std::vector<std::vector<Vec2>>>& land = {});

/// Records that a run has made since the last ones, as one line of JSON. Only `initial_sheet`, `cracked_sheets`,
/// `loads`, `events`, `floes` (births) and `frames` are looked at. Poses are rounded as in a report.
std::string live_records(const model::RunResults& part, const std::vector<EndedFloe>& ended);

}  // namespace brash::report
