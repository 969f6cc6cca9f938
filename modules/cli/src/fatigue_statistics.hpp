// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "load_history.hpp"

namespace brash::cli {

/// Damage-equivalent loads of histories of one process, pooled, for each exponent of an S-N curve; with 95 % intervals.
///
/// @param stretch    independent stretches are at least so long [s].
/// @param frequency  of the equivalent sinusoid [Hz].
nlohmann::ordered_json fatigue_json(const std::vector<const LoadHistory*>& loads, const std::vector<double>& exponents,
                                    double stretch, double frequency);

/// The same as text for a reader; "" for an empty array.
std::string fatigue_text(const nlohmann::ordered_json& fatigue);

}  // namespace brash::cli
