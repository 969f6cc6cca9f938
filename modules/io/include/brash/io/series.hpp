// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace brash::io {

/// Numbers of the rows of a table in its file. They rise by one but for a few places, and only these are kept.
class RowNumbers {
 public:
  void add(std::size_t number);
  std::size_t operator[](std::size_t row) const;
  std::size_t size() const { return size_; }

 private:
  struct Stretch {
    std::size_t row = 0, number = 0;  ///< of its first row
  };
  std::vector<Stretch> stretches_;
  std::size_t size_ = 0;
};

/// Columns of numbers as measured and simulated histories come.
struct Series {
  std::vector<std::string> names;  ///< without their units
  std::vector<std::string> heads;  ///< as the file has them: "Fx [kN]"
  /// Of the values: a unit of SI when the file's unit converts to newtons, newton metres, pascals, metres, metres a
  /// second (also squared), radians or, for times, seconds; else as the file has it; empty where it has none.
  std::vector<std::string> units;
  std::vector<double> factors;               ///< one unit of the file in that unit
  std::vector<std::vector<double>> columns;  ///< shape=(n_names, n_rows); not a number where a value is missing
  /// Which column holds the times, in seconds and finite; absent when there is none.
  std::optional<std::size_t> time;
  std::string start;  ///< the date at which the times are 0, as the file writes it; empty: the file has no dates
  std::vector<std::string> notes;  ///< of lines that were left out; messages without the file
  std::string row_prefix;          ///< with the row's number the place of a row, for messages: "FILE:", "FILE, sample "
  RowNumbers rows;                 ///< lines of the file, or samples from 1 on

  std::string place(std::size_t row) const { return row_prefix + std::to_string(rows[row]); }
};

/// Reads a table of at least two rows: netCDF when the name ends in .nc, else text.
///
/// Text: numbers separated by semicolons, tabs, commas or blanks, the first of these that the first line holds; an
/// optional first line of names (without it the names are 1, 2, ...); lines that begin with # are skipped. A title
/// above the names is left out with a note. Cells may be in quotes. Between semicolons or tabs the decimal mark may
/// be a comma; one mark in the whole file. An empty cell, `nan`, `NaN`, `NA` or `-` is missing. A name may have a unit
/// in brackets, `time [ms]`, `Fx (kN)`, between blanks too, or at its end, `time_ms`, `Fx_kN`; or the units are in a
/// line of their own under the names. Times: the column named `time`, `t` or the like, capitals or not; else the first
/// of several, when it has a unit of time or the table has no names. Dates such as 2024-02-01T12:00:00 count in seconds
/// from the first row on.
///
/// OpenFAST's text output (.out): as text, from the line on that begins with Time. Remarks in words after the rows are
/// left out with a note. Binary formats are refused by their names.
///
/// netCDF: the dimension of the variable `time` or `t` (or, without those, of the first variable along one dimension
/// whose unit is "... since ..."), and all numeric variables along it alone. Fill values are missing, packed values are
/// unpacked.
///
/// @param missing  values that stand for a missing one, in the units of the file.
/// @throws InputError naming file, line or variable, and the fault.
Series read_series(const std::string& path, const std::vector<double>& missing = {});

/// Seconds in a unit such as "ms" or "hours since 2024-01-01"; empty: 1.
/// @param place  for the message.
/// @throws InputError when it is not a unit of time.
double seconds_in(const std::string& unit, const std::string& place);

}  // namespace brash::io
