// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "blocks.hpp"
#include "long_history.hpp"

namespace brash::report {

/// The drawn statistics of each load, Fx to Mz, after `from` up to `until` [s]: spectrum with its confidence factors,
/// and the peaks between upward crossings of the mean, largest first. A load that acts towards its lower end has its
/// peaks there, as `lower_end` says. Null where the history is too short. A spectrum of many lines keeps the lowest and
/// the highest line of narrow bands. `blocks` gets the samples sorted, the largest in size first:
/// `exceedance`.Fx.value, and .rank: how many are as large. Between the largest ones and the last, ranks lie evenly by
/// their logarithm.
nlohmann::ordered_json load_statistics(const LoadSamples& samples, double from, double until, Blocks& blocks);

}  // namespace brash::report
