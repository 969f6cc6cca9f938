// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "brash/failure/criterion.hpp"

namespace brash::failure {

// One function per model; each file holds one.
std::unique_ptr<BendingCriterion> make_network_criterion(const std::string& file, const IceProperties& ice);
std::unique_ptr<BendingCriterion> make_superposition_criterion(const std::string& file, const IceProperties& ice);
std::unique_ptr<BendingCriterion> make_plate_criterion(const IceProperties& ice);
std::unique_ptr<BendingCriterion> make_wedge_criterion(const IceProperties& ice);

/// Throws ContractViolation when `load` is not a load case.
void expect_valid(const LoadCase& load);

}  // namespace brash::failure
