// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "brash/statistics/history.hpp"

namespace brash::statistics {

/// One load event: the load rises from a level to its peak and falls back to the level.
struct LoadEvent {
  double start = 0.0;          ///< the load rises through the level [s]
  double end = 0.0;            ///< the load falls through the level [s]
  double peak_time = 0.0;      ///< [s]
  double peak = 0.0;           ///< largest sample, unit of the load
  double impulse = 0.0;        ///< integral of the load from start to end, unit of the load times s
  std::size_t peak_index = 0;  ///< sample of the peak in the history

  double rise() const { return peak_time - start; }
  double fall() const { return end - peak_time; }
};

/// The levels between which a load event begins and ends.
struct EventLevels {
  double level = 0.0;  ///< start and end are taken here, unit of the load
  double upper = 0.0;  ///< an event needs a sample above this level
  double lower = 0.0;  ///< an event is over when a sample is below this level
};

/// Deviation of white noise on a smooth signal: the median size of the second differences over its value for noise.
///
/// It is 0 for a signal that is piecewise linear. Noise that is correlated from sample to sample is underestimated.
/// @param pieces  evenly sampled.
/// @see docs/theory/statistics.md, (S8).
double noise_floor(const Pieces& pieces);

/// Width of the dead band that noise alone seldom crosses: five times the noise floor, three deviations of the load at
/// most, so that a load that is all noise has events too; unit of the load.
double noise_band(const History& history, const EvenHistory& even);

/// Levels around `level` with a dead band that noise alone seldom crosses.
///
/// @param history    its extremes bound the band: it ends half-way to the smallest and to the largest sample.
/// @param level      usually the mean, unit of the load.
/// @param dead_band  width, unit of the load, >= 0; absent: noise_band().
EventLevels event_levels(const History& history, const EvenHistory& even, double level,
                         std::optional<double> dead_band = std::nullopt);

/// The load events of a history, in the order of time. An event that begins or ends in a gap, or outside the record, is
/// left out.
///
/// @param levels  lower <= level <= upper.
std::vector<LoadEvent> load_events(const History& history, const EvenHistory& even, const EventLevels& levels);

/// Mean time between the events of a history [s]; infinite below two events.
double load_cycle(const std::vector<LoadEvent>& events, double duration);

/// A level at which the sensor seems to have been at its limit.
struct Clipping {
  double value = 0.0;       ///< unit of the load
  std::size_t samples = 0;  ///< at that value
};

/// Looks for load events that stay at the largest value of the history longer than rounding explains.
///
/// The flat top of a load event is its longest run of samples at its peak. Rounded values have flat tops too. The
/// sensor clips if one flat top at the largest value has five samples and three times the median flat top of the lower
/// events, or if two such flat tops have two samples and twice the median. A constant history is not clipped. Neither
/// is a history whose largest value is 0.
/// @see docs/theory/statistics.md, Load events.
std::optional<Clipping> clipping(const History& history, const EvenHistory& even);

}  // namespace brash::statistics
