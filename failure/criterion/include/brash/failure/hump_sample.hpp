// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/meta_model/hump_training.hpp"
#include "brash/meta_model/profile_model.hpp"

namespace brash::failure {

/// One row for a HumpNetwork to learn from, answered by the superposition instead of the plate: the largest stress on
/// the centre line up to kHumpBoundary and beyond it.
/// @param input  moved into the range of `model`.
meta_model::HumpSample hump_sample(const meta_model::ProfileModel& model, const meta_model::Input& input,
                                   double thickness_over_lc);

}  // namespace brash::failure
