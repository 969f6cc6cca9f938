// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "brash/training/edge_database.hpp"

namespace brash::training {

/// Writes `database` as netCDF-4 to `path` by rename when whole.
/// @throws RunError when it cannot be written.
void write_edge_database(const std::string& path, const EdgeDatabase& database);

}  // namespace brash::training
