// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace brash::statistics {

/// What a filter does to the phase.
enum class Phase {
  kZero,    ///< forward and backward: nothing is shifted, and a step shows before it happens
  kCausal,  ///< forward alone, as in an instrument: later by low_pass_delay()
};

/// Low-pass filtered samples: Butterworth's filter of second order, once (causal) or forward and backward (zero phase).
///
/// The amplitude at `cut_off` is 1/sqrt(2) in both. The ends are continued by odd reflection (zero phase) or by the
/// first sample (causal).
/// @param samples  shape=(n,), finite, evenly sampled every `dt` [s].
/// @param cut_off  [Hz], above 0 and below half of the sampling frequency.
/// @see docs/theory/statistics.md, (S13).
std::vector<double> low_pass(std::span<const double> samples, double dt, double cut_off, Phase phase);

/// By how much the causal filter delays slow loads: sqrt(2)/(2 pi cut_off) [s]; the other does not.
double low_pass_delay(double cut_off, Phase phase);

}  // namespace brash::statistics
