// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "brash/model/records.hpp"

namespace brash::report {

/// The drawn statistics of each load, Fx to Mz, after `from` up to `until` [s]: spectrum with its confidence factors,
/// and the peaks between upward crossings of the mean, largest first. A load that acts towards its lower end has its
/// peaks there, as `lower_end` says. Null where the history is too short.
nlohmann::ordered_json load_statistics(const std::vector<model::LoadRow>& loads, double from, double until);

}  // namespace brash::report
