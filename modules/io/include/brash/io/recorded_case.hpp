// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "brash/io/case.hpp"

namespace brash::io {

/// As parse_case() for a case that a run has recorded, in a run.nc or a checkpoint. The files of [field] may be gone,
/// and a checkpoint leaves out their names; so nothing asks for these files, or for the keys that replace them.
model::Case parse_recorded_case(const std::string& text, const std::string& path,
                                const std::vector<std::string>& overrides, ModelFile model_file);

}  // namespace brash::io
