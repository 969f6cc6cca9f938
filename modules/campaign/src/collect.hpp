// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "brash/campaign/campaign.hpp"
#include "folder.hpp"
#include "schedule.hpp"

namespace brash::campaign {

/// Writes the tables and the manifest of the cases that are done or failed.
/// @throws RunError naming the file and the reason. @throws InputError when a case's summary cannot be read.
void collect(const Campaign& campaign, const Folder& folder, const Schedule& schedule);

/// Name of the description of a campaign's folder as a research object (RO-Crate 1.1).
constexpr const char* kCrateFile = "ro-crate-metadata.json";

/// Writes `kCrateFile` into the folder of a campaign that is done: its files with sizes and SHA-256, and the program.
///
/// The manifest of a case is listed with its hash and holds the hashes of the case's other files. The licence and the
/// authors of the results are the user's: their entries in an earlier description are kept, with the entities to which
/// these lead, such as a person.
/// @throws StorageError when it cannot be written; RunError when a listed file cannot be read.
/// @see https://www.researchobject.org/ro-crate/specification/1.1/
void write_crate(const std::string& directory);

}  // namespace brash::campaign
