// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/meta_model/training.hpp"

namespace brash::meta_model {

/// Errors in the parts of the range that behave differently; parts without rows are left out.
std::vector<Region> errors_by_region(const Network& network, const std::vector<Sample>& samples);

}  // namespace brash::meta_model
