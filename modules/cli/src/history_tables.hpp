// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "load_history.hpp"

namespace brash::cli {

/// A table for a CSV file: its names, and its lines.
struct CsvTable {
  std::string names;  ///< "a,b\n"
  std::string lines;
};

/// Load events, one line each: start, end, peak_time, peak, impulse, rise, fall; for the history of a run also the
/// cause with the largest share of the peak, and the crack nearest to the peak.
///
/// The causes are the columns of the file whose names end in `_COLUMN`, such as crushing_Fx. The cracks are the breaks
/// in the events.csv beside it.
/// @param dead_band  in deviations of the load; absent: from the noise floor.
CsvTable events_table(const LoadHistory& load, std::optional<double> dead_band);

/// How long and how often the load is above fifty levels: level, time_above [s], share, events_above.
CsvTable exceedance_table(const LoadHistory& load, std::optional<double> dead_band);

/// Rainflow cycles: range, mean, count, end [s].
CsvTable cycles_table(const LoadHistory& load);

/// Welch's spectrum with its 95 % band: frequency, density, lower_95, upper_95.
/// @throws InputError when the history or the segment is shorter than 16 samples.
CsvTable spectrum_table(const LoadHistory& load, double segment);

}  // namespace brash::cli
