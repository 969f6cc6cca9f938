// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/campaign/campaign.hpp"
#include "folder.hpp"
#include "schedule.hpp"

namespace brash::campaign {

/// Writes the tables and the manifest of the cases that are done or failed.
/// @throws RunError naming the file and the reason. @throws InputError when a case's summary cannot be read.
void collect(const Campaign& campaign, const Folder& folder, const Schedule& schedule);

}  // namespace brash::campaign
