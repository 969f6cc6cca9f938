// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "brash/failure/criterion.hpp"

namespace brash::failure {

// One function per model; each file holds one.
std::unique_ptr<BendingCriterion> make_network_criterion(const std::string& file, const IceProperties& ice);
std::unique_ptr<BendingCriterion> make_superposition_criterion(const std::string& file, const IceProperties& ice);
std::unique_ptr<BendingCriterion> make_plate_criterion(const IceProperties& ice, const BendingOptions& options);
std::unique_ptr<BendingCriterion> make_outline_criterion(const IceProperties& ice, const BendingOptions& options);
std::unique_ptr<BendingCriterion> make_wedge_criterion(const IceProperties& ice);

/// Where a fast answer excludes failure.
struct Screen {
  double harmless_stress = 0.0;    ///< of the fast criterion [Pa]
  double harmless_pressure = 0.0;  ///< of the load [Pa]
};

/// `exact`, asked only where `fast` exceeds the harmless stress, is out of its range above, the load exceeds the
/// harmless pressure, or has none; elsewhere the answer is that of `fast`.
std::unique_ptr<BendingCriterion> make_screened_criterion(std::unique_ptr<BendingCriterion> fast,
                                                          std::unique_ptr<BendingCriterion> exact,
                                                          const Screen& screen);

/// Throws ContractViolation when `load` is not a load case.
void expect_valid(const LoadCase& load);

/// The plate with the load's trapezoid, solved; `l_c` is that of `ice`.
/// @throws RunError when it cannot be meshed.
Assessment assess_trapezoid(const IceProperties& ice, double l_c, const LoadCase& load, const BendingOptions& options);

/// N / sqrt(k D) of the load where the second order is asked for, else 0.
double in_plane_load(const IceProperties& ice, double l_c, const LoadCase& load, const BendingOptions& options);

}  // namespace brash::failure
