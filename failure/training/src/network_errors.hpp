// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/training/network_training.hpp"

namespace brash::training {

/// Errors in the parts of the range that behave differently; parts without rows are left out.
std::vector<Region> errors_by_region(const Network& network, const std::vector<Sample>& samples);

}  // namespace brash::training
