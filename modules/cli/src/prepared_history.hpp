// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "brash/statistics/filter.hpp"
#include "load_history.hpp"

namespace brash::cli {

/// What is done to a history before its statistics; 0: nothing.
struct Preparation {
  double low_pass = 0.0;  ///< cut-off [Hz]
  double step = 0.0;      ///< new time step [s]
  statistics::Phase phase = statistics::Phase::kZero;

  bool any() const { return low_pass > 0.0 || step > 0.0; }
};

/// Filters and resamples the pieces of a history; gaps stay.
///
/// Samples of a coarser step come from a zero-phase low-pass at 0.4 of the new sampling frequency, then from straight
/// lines between samples. Clipping is looked for in the samples as they were taken.
/// @throws InputError when the cut-off is not below half of the sampling frequency, or the step makes more than 2^27
///   samples.
LoadHistory prepared(const LoadHistory& load, const Preparation& preparation);

/// The preparation for JSON: cut-off, phase, delay, step.
nlohmann::ordered_json preparation_json(const Preparation& preparation);

}  // namespace brash::cli
