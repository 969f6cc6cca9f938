// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/io/results.hpp"
#include "netcdf_file.hpp"

namespace brash::io {

/// Writes everything of `results` as netCDF variables; read_tables gives it back.
void write_tables(NetcdfWriter& file, const model::RunResults& results);
/// @throws InputError when the file lacks something or its counts do not add up.
model::RunResults read_tables(const NetcdfReader& file);

}  // namespace brash::io
