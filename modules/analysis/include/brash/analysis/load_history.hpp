// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brash/io/file_names.hpp"
#include "brash/model/origin.hpp"
#include "brash/model/warning.hpp"
#include "brash/statistics/events.hpp"
#include "brash/statistics/filter.hpp"
#include "brash/statistics/history.hpp"

namespace brash::analysis {

/// A value that loggers write for a missing one.
struct MissingMarker {
  double value = 0.0;  ///< in the unit of the file
  std::size_t n = 0;   ///< samples that have it
};

/// The value of usual markers (-9999, 999, 1e30 and the like) that lies apart from all others: it is the least or the
/// largest, further from the next one than a tenth of the range of the others.
/// @param factor  one unit of the file in the unit of the values.
std::optional<MissingMarker> missing_marker(std::span<const double> values, double factor);

/// The warning of such a value; "" without one.
std::string marker_warning(const std::optional<MissingMarker>& marker);

/// One column of a file against time.
struct LoadHistory {
  std::string column;
  statistics::History history;
  statistics::EvenHistory even;
  std::size_t n_missing = 0;  ///< rows of the file in which the column has no value
  std::string unit{};         ///< of the values, as io::Series has it; empty: the file states none
  std::string file{};         ///< as given
  std::string start{};        ///< the date at which the times are 0; empty: none is known
  bool is_negated = false;    ///< the file has it with the other sign, under the column's name without its -
  /// Limit of the sensor, found in the samples before a filter or a new step hid it; absent: look at `history`.
  std::optional<statistics::Clipping> clipping{};
  std::optional<MissingMarker> marker{};   ///< that the file may have for missing values
  std::vector<model::Warning> warnings{};  ///< in the summary.json beside the file; none beside a measurement
  model::Origin origin{};                  ///< of the run that it is of; empty for a measurement
};

/// Which column to read and how.
struct HistoryChoice {
  std::string column;  ///< with or without its unit; empty: the first one that is not the time
  double dt = 0.0;     ///< [s], for files without times, which others refuse; 0: the file has them
  double from = 0.0;   ///< leave out samples before this time [s]; of a run, whose steps end at them, also at it
  bool has_from = false;
  bool after = false;             ///< leave out a sample at `from` too, as a summary does
  std::optional<double> to{};     ///< leave out samples after this time [s]
  double longest_interval = 0.0;  ///< a longer interval is a gap [s]; 0: five times the median
  std::vector<double> missing{};  ///< values that stand for a missing one, in the unit of the file
  bool negate = false;            ///< turn the sign of the loads
  io::Notes notes{};              ///< hears which lines of a text were left out
};

/// The file of a history: `given`, or if it is the folder of a run, the run.nc or history.csv in it.
/// @throws InputError naming a folder without them.
std::string history_file(const std::string& given);

/// Reads a column of a run.nc, named as in history.csv, or of any file that io::read_series reads.
///
/// @throws InputError naming file, place and fault: no such column, not a number, times that do not rise, times beside
///   a time step, fewer than two samples.
LoadHistory read_history(const std::string& path, const HistoryChoice& choice);

/// The history with the other sign; its column is named -column.
LoadHistory negated(LoadHistory load);

/// Reads several columns of one file, in the order of `columns`; without any, the column of `choice`.
std::vector<LoadHistory> read_histories(const std::string& path, const HistoryChoice& choice,
                                        const std::vector<std::string>& columns);

/// The warnings of the runs that histories are of, each once: "of 3 of 20 runs: few-samples: ...".
std::vector<std::string> run_warnings(std::span<const LoadHistory> loads);

/// The origins of all runs that histories are of.
model::Origin origin_of(std::span<const LoadHistory> loads);

/// Changes to a history before its statistics; 0: none.
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

}  // namespace brash::analysis
