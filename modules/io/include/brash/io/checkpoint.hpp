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

/// Writes the rows of `rows` to a file of their own, beside a checkpoint that names it.
/// @return the digest of the file. @throws RunError as write_checkpoint().
std::string write_earlier_rows(const std::string& path, const model::RunResults& rows);

/// Reads the file of write_earlier_rows() back.
/// @throws InputError as read_checkpoint(), and for a file with another digest.
model::RunResults read_earlier_rows(const std::string& path, const std::string& digest);

}  // namespace brash::io
