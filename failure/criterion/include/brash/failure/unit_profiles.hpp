// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/meta_model/profile_model.hpp"
#include "brash/plate/plate.hpp"

namespace brash::failure {

/// Interpolated profiles as the plate solver would give them; no values at the roots.
plate::UnitProfiles to_unit_profiles(const meta_model::Profiles& profiles);

}  // namespace brash::failure
