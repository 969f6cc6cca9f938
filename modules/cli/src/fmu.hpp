// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brash/fmu/model_description.hpp"

namespace brash::cli {

/// Writes a case as a co-simulation unit.
/// @param file                 of the unit, .fmu.
/// @param velocity_from_poses  of a driven structure: the host gives poses alone.
/// @throws InputError as io::read_case, and for a case that no unit can hold; StorageError.
void export_fmu(const std::string& case_file, const std::vector<std::string>& overrides, const std::string& file,
                fmu::Standard standard, bool velocity_from_poses);

}  // namespace brash::cli
