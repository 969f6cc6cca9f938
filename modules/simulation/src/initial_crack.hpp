// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/failure/criterion.hpp"
#include "brash/model/case.hpp"

namespace brash::simulation {

/// Radius of Fig. 5's crack [m]: as given, or where the failure model breaks a straight edge under a contact as long
/// as the ice is thick.
double initial_crack_radius(const model::Case& resolved, const failure::IceProperties& ice,
                            const failure::BendingCriterion& criterion);

}  // namespace brash::simulation
