// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "brash/io/result_pieces.hpp"
#include "brash/io/results.hpp"
#include "netcdf_file.hpp"

namespace brash::io {

/// Writes everything of `results` as netCDF variables; read_tables gives it back.
void write_tables(NetcdfWriter& file, const model::RunResults& results);
/// @throws InputError when the file lacks something or its counts do not add up.
model::RunResults read_tables(const NetcdfReader& file);
/// Pieces that are gathered in `loads` and `frames`.
ResultPieces all_of(std::vector<model::LoadRow>& loads, std::vector<model::Frame>& frames);
/// The same piece by piece: loads and frames go to `pieces`, the others are returned.
/// @param begin  hears the others before the first piece.
model::RunResults read_tables(const NetcdfReader& file, const ResultPieces& pieces,
                              const std::function<void(const model::RunResults&)>& begin);

}  // namespace brash::io
