// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "blocks.hpp"
#include "long_history.hpp"

namespace brash::report {

/// The statistics of each load as `brash stats --json` has them, for the page's charts. A spectrum of many lines keeps
/// the lowest and the highest line of narrow bands, and `n_lines` says how many there were. `blocks` gets the samples
/// after `from` up to `until` [s] sorted, the largest in size first: `exceedance`.Fx.value, and .rank: how many are as
/// large. Between the largest ones and the last, ranks lie evenly by their logarithm.
///
/// @param statistics  of Fx to Mz, each with `spectrum` and `lower_end`; null stays null.
nlohmann::ordered_json drawn_statistics(nlohmann::ordered_json statistics, const LoadSamples& samples, double from,
                                        double until, Blocks& blocks);

}  // namespace brash::report
