// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brash/io/series.hpp"

namespace brash::io {

/// Whether a column of this name, without its unit, holds times.
bool is_time_name(std::string_view name);

/// Converts all columns except the times to SI and names their new unit. Columns in a unit that does not belong to
/// loads or to quantities measured beside loads stay unchanged.
void convert_to_si(Series& series);

/// @throws InputError, always: the row at `place` has no time.
[[noreturn]] void refuse_missing_time(const std::string& place);

/// Makes each value of a column, but of the times, missing that is one of these.
void leave_out(Series& series, const std::vector<double>& missing);

Series read_netcdf_series(const std::string& path, const std::vector<double>& missing);

/// More columns than anyone measures, and few enough to make room for.
constexpr std::size_t kMostColumns = 10'000;

/// How the numbers of a text are written.
struct Layout {
  char separator = ' ';
  char decimal_mark = 0;  ///< of the numbers met so far; 0: whole numbers only
};

std::string_view without_blanks(std::string_view text);

/// The separator of the cells: the first of semicolon, tab and comma that the first line holds, else blanks.
char separator_of(std::string_view first_line);

/// Cells of a line, without blanks and quotes. Of more than kMostColumns, the first.
std::vector<std::string_view> cells_of(std::string_view line, char separator);

/// Joins the units in brackets of a line of names between blanks to their names: `Fx [kN]` is one cell. A line that
/// begins with a unit holds units alone.
std::vector<std::string_view> with_units(const std::vector<std::string_view>& cells);

/// A finite number, not a number for a missing one, nothing for anything else. The first decimal mark is the one of
/// all.
std::optional<double> number_in(std::string_view cell, Layout& layout);

}  // namespace brash::io
