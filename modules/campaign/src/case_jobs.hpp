// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "brash/campaign/pool.hpp"
#include "folder.hpp"

namespace brash::campaign {

/// The process that runs the case `key`; makes its partial folder.
Job job_of(const CaseKey& key, const Folder& folder, const std::string& program, const std::string& keep);

/// Records the failure of a case that ended by itself without results; a case that was interrupted or killed from
/// outside stays missing.
/// @throws StorageError when the case could not write its files: then no other case could.
void judge(const CaseKey& key, const Folder& folder, const Exit& exit);

}  // namespace brash::campaign
