// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "brash/model/records.hpp"

namespace brash::io {

/// Who takes the two tables that grow with the duration of a run, in the order of the file.
struct ResultPieces {
  std::function<void(std::vector<model::LoadRow>&& rows, std::size_t n_all)> loads;  ///< the next of `n_all` rows
  std::function<void(model::Frame&& frame)> frame;
};

/// Reads a run.nc piece by piece, so that only `pieces` says how much of a long run is in memory together.
/// @return all but the loads and the frames. @throws InputError as the whole read_results() does, perhaps after some
/// pieces.
model::RunResults read_results(const std::string& path, const ResultPieces& pieces);

}  // namespace brash::io
