// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

}  // namespace brash::io
