// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "brash/statistics/random.hpp"
#include "brash/statistics/summary.hpp"

namespace brash::statistics {

/// A load cycle, or half of one.
struct Cycle {
  double range = 0.0;     ///< from valley to peak, unit of the load
  double mean = 0.0;      ///< of valley and peak, unit of the load
  double count = 1.0;     ///< 1 for a cycle, 0.5 for half of one
  std::size_t index = 0;  ///< of the sample at which its range ends
};

/// Counts the cycles of a history by the rainflow method: three reversals at a time, halves at the ends.
///
/// @param samples  shape=(n,), finite; its first and last sample are reversals.
/// @see ASTM E1049-85, Sec. 5.4.4; docs/theory/statistics.md, Fatigue.
std::vector<Cycle> rainflow(std::span<const double> samples);

/// Sum of count range^exponent over the cycles, in (unit of the load)^exponent.
///
/// @param exponent  m of the S-N curve, >= 1 [-].
double damage(std::span<const Cycle> cycles, double exponent);

/// Range of the sinusoid that does the same damage in the same time, (damage / (frequency duration))^(1/exponent).
///
/// @param duration   of the history [s], > 0.
/// @param frequency  of the sinusoid [Hz], > 0; 1 Hz is usual.
/// @see docs/theory/statistics.md, (S12).
double damage_equivalent_load(double damage, double exponent, double duration, double frequency = 1.0);

/// Damage of the stretches of a history, each cycle where its range ends; the last stretch takes the remainder.
///
/// @param stretch  length [samples], >= 1; a history shorter than two stretches is one.
/// @return damages and lengths in samples, shape=(n_stretches,) each.
struct StretchDamages {
  std::vector<double> damages;
  std::vector<double> lengths;  ///< [samples]
};
StretchDamages damage_by_stretch(std::span<const Cycle> cycles, double exponent, std::size_t n_samples,
                                 std::size_t stretch);

/// Interval of the mean damage a sample from independent stretches: the bootstrap of the ratio of sums, on its
/// logarithm and divided by the error of each resample (bootstrap-t).
///
/// @param stretches  at least 2, with damages that are not all 0.
/// @return [0, infinity] when the stretches give no error of their own.
Interval damage_rate_interval(const StretchDamages& stretches, double confidence, RandomStream& stream);

/// Share of the damage in the long run that is done by ranges above the largest one seen, from Pareto's law of the
/// largest ranges, or an exponential one where its shape is negative; 1 when that damage has no bound or there are too
/// few cycles for the law.
///
/// Above kMostUnseen the record lacks the cycles that do the damage, and an interval rests on a law of their tail.
double unseen_damage(std::span<const Cycle> cycles, double exponent);
inline constexpr double kMostUnseen = 0.1;

/// Upper end of the damage in the long run, over the damage of the record, if the tail of the largest ranges is
/// exponential or lighter.
///
/// Resamples of a record hold no cycle larger than any seen, so the upper end of damage_rate_interval() may be too low.
/// The damage below a threshold is taken as seen. The damage above it is of an exponential tail, whose scale is at the
/// upper end of its exact interval; the Poisson error of the number of cycles adds in quadrature.
/// @return infinity when the largest ranges have a heavier tail at the confidence, or are too few.
/// @see docs/theory/statistics.md, (S15).
double largest_damage_ratio(std::span<const Cycle> cycles, double exponent, double confidence);

}  // namespace brash::statistics
