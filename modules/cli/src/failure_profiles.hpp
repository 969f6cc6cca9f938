// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/database/database.hpp"
#include "brash/meta_model/profile_model.hpp"
#include "brash/plate/plate.hpp"

namespace brash::cli {

meta_model::ProfileSample to_profile_sample(const database::Record& record);

/// The interpolated profiles as the plate solver would give them; no values at the roots.
plate::UnitProfiles to_unit_profiles(const meta_model::Profiles& profiles);

/// Prints the errors of `model` on the rows of records that it has not seen.
void print_profile_errors(const meta_model::ProfileModel& model, const std::vector<const database::Record*>& records);

}  // namespace brash::cli
