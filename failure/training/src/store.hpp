// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "brash/training/database.hpp"
#include "brash/training/edge_database.hpp"

namespace brash::training {

/// Writes `database` as netCDF-4 to `path` by rename when whole.
/// @throws RunError when it cannot be written.
void write_database(const std::string& path, const Database& database);

/// Writes `database` as netCDF-4 to `path` by rename when whole.
/// @throws RunError when it cannot be written.
void write_edge_database(const std::string& path, const EdgeDatabase& database);

/// Removes the chunks of `path`, and their folder once it is empty: the holder of the lock in it removes it otherwise.
void remove_chunks(const std::string& path);

/// @throws InputError when the folder of the chunks holds a file that no build left, or is a link.
void refuse_files_of_others(const std::string& path);

}  // namespace brash::training
