// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace brash::cli {

/// One evenly sampled column of a file.
struct LoadHistory {
  std::string column;
  double start = 0.0;  ///< time of the first sample [s]
  double dt = 0.0;     ///< [s]
  std::vector<double> samples;
};

/// Which column to read and how.
struct HistoryChoice {
  std::string column;  ///< empty: the first one that is not the time
  double dt = 0.0;     ///< [s], for files without a column of times; 0: the file has one
  double from = 0.0;   ///< leave out samples before this time [s]
  bool has_from = false;
};

/// Reads a column of a run.nc, named as in history.csv, or of a CSV file: numbers separated by commas, semicolons, tabs
/// or blanks; an optional first line of names; lines that begin with # are skipped. The times stand in the column
/// `time`, `t` or `Time`, else in the first of several.
///
/// @throws InputError naming file, line and what is wrong: no such column, not a number, times that do not rise evenly
/// (no
///   step may differ from their mean by more than half), fewer than two samples.
LoadHistory read_history(const std::string& path, const HistoryChoice& choice);

}  // namespace brash::cli
