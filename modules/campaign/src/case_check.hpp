// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "brash/model/case.hpp"

namespace brash::campaign {

/// Why a done case is not as its campaign made it; empty: it is. Its manifest has to name this case and replicate, and
/// the results have to have the hashes of the manifest.
/// @param expected  the case as results record it.
std::string why_unfit(const std::filesystem::path& case_folder, const model::Case& expected);

}  // namespace brash::campaign
