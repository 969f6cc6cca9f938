// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brash/model/checkpoint.hpp"

namespace brash::io {

/// Writes a checkpoint (netCDF-4) by rename when whole: the older one stays until then.
/// @throws RunError naming the file and the system's reason.
void write_checkpoint(const std::string& path, const model::Checkpoint& checkpoint);

/// The same for a state in its parts: `results` of a long run need no copy.
void write_checkpoint(const std::string& path, const model::Case& resolved, const std::vector<model::Table>& tables,
                      const model::RunResults& results);

/// Reads a checkpoint from write_checkpoint, bit for bit.
/// @throws InputError naming the file and its fault.
model::Checkpoint read_checkpoint(const std::string& path);

}  // namespace brash::io
