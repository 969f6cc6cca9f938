// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "brash/statistics/summary.hpp"

namespace brash::statistics {

/// A load history as it was sampled, perhaps unevenly and with gaps.
struct History {
  std::vector<double> times;   ///< rising [s]; shape=(n,), n >= 2
  std::vector<double> values;  ///< finite [N]; shape=(n,)
};

/// Two successive samples between which the history is unknown.
struct Gap {
  double from = 0.0;  ///< [s]
  double to = 0.0;    ///< [s]
};

/// How a history was sampled.
struct Sampling {
  /// Time between samples [s]: the mean, or if only single samples are lost, the step of the others. Gaps do not count,
  /// here and below.
  double step = 0.0;
  double shortest = 0.0;  ///< time between two samples [s]
  double longest = 0.0;   ///< time between two samples [s]
  /// In each piece between gaps no time is further than a tenth of a step from an even grid of `step`, which begins at
  /// the first time of the piece. A history most of whose pieces have one sample is not even.
  bool even = true;
  std::size_t n_lost = 0;  ///< samples that lack on an even grid of `step`, apart from gaps; 0 if there is no such grid
  std::vector<Gap> gaps;
};

/// A history cut at its gaps and made even.
struct EvenHistory {
  Sampling sampling;
  /// Time that each sample represents [s]; shape=(n,) of the history, or (1,) where it is even.
  std::vector<double> weights;
  std::vector<std::size_t> cuts;               ///< first sample of each piece, and n
  std::vector<std::vector<double>> resampled;  ///< values every `sampling.step` of each piece; none where even
  double duration = 0.0;                       ///< sum of the weights [s]

  /// Time that a sample represents [s].
  double weight(std::size_t sample) const { return weights[weights.size() == 1 ? 0 : sample]; }
  /// Values every `sampling.step`, piece by piece: of an even history its samples themselves.
  Pieces pieces(const History& history) const;
};

/// Cuts a history at its gaps and resamples the uneven pieces.
///
/// A gap is an interval longer than `longest_interval`. A sample represents half of the interval on either side, for
/// half a step where there is a gap or an end. An uneven piece is interpolated linearly, which lowers its spectrum
/// above about a fifth of the sampling frequency; an even one is taken as it is.
///
/// @param longest_interval  [s]; 0: five times the median interval.
/// @see docs/theory/statistics.md, Uneven sampling and gaps.
EvenHistory make_even(const History& history, double longest_interval = 0.0);

/// The warning of gaps that may be a change of the sampling rate: they cover more than a tenth of the time, or most
/// pieces between them have one sample; "" for others. `--gap` is the `longest_interval` above.
std::string gap_warning(const History& history, const EvenHistory& even);

/// The autocorrelation time of a load: the time of its samples, or the time of its averages over five load cycles, if
/// that one is larger by two of its errors.
///
/// The window of the samples may close within a load cycle, where the autocorrelations of a sawtooth cancel. It misses
/// slower changes then, such as a drift of the peaks. Averages over m samples have the time
/// tau_m var(averages) / var(samples). They count if there are at least twenty averages in the longest piece.
/// @see docs/theory/statistics.md, (S2), (S17); H. Flyvbjerg, H. G. Petersen, J. Chem. Phys. 91 (1989) 461.
AutocorrelationTime autocorrelation_time(const History& history, const EvenHistory& even);

/// Summary of a stationary history, even or not, with or without gaps.
///
/// Even: the same as of evenly sampled values. Else mean, deviation, skewness and quantiles weigh each sample with its
/// time. The autocorrelation time is estimated from the even pieces; no pair of samples straddles a gap.
Summary summarise(const History& history, const EvenHistory& even);

/// The samples between gaps as they were taken, not resampled.
Pieces raw_pieces(const History& history, const EvenHistory& even);

}  // namespace brash::statistics
