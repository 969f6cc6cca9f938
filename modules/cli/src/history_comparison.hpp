// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "load_history.hpp"

namespace brash::cli {

/// A run's history against a measured one: mean, deviation, peaks, distribution and spectrum, each with a 95 % interval
/// or a test. `differs` names the statistics that differ at 5 %, all tests adjusted together by Holm's method.
nlohmann::ordered_json compare_histories(const LoadHistory& run, const LoadHistory& measured);

/// The same as text for a reader.
std::string comparison_text(const nlohmann::ordered_json& comparison);

/// The same as a picture (SVG): both histories, ratios with their intervals, distributions, spectra with their bands.
std::string comparison_picture(const LoadHistory& run, const LoadHistory& measured,
                               const nlohmann::ordered_json& comparison);

}  // namespace brash::cli
