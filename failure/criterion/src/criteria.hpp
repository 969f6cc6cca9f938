// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "brash/failure/criterion.hpp"

namespace brash::failure {

/// The path of the model `name` that comes with the program.
std::string shipped(const std::string& name);

// One function per model; each file holds one.
std::unique_ptr<BendingCriterion> make_network_criterion(const std::string& file, const IceProperties& ice,
                                                         const BendingOptions& options);
/// @param split_file  the model of the sheet that a radial crack has split; read where the options ask for it.
std::unique_ptr<BendingCriterion> make_superposition_criterion(const std::string& file, const std::string& split_file,
                                                               const IceProperties& ice, const BendingOptions& options);
std::unique_ptr<BendingCriterion> make_plate_criterion(const IceProperties& ice, const BendingOptions& options);
/// @param screen  of the trapezoid, first: the sheet is solved where it does not stay far below the strength.
std::unique_ptr<BendingCriterion> make_outline_criterion(std::unique_ptr<BendingCriterion> screen,
                                                         const IceProperties& ice, const BendingOptions& options);
std::unique_ptr<BendingCriterion> make_wedge_criterion(const IceProperties& ice);

/// `exact`, asked only where `fast` exceeds the strength of `ice` over `margin`, buckles, is out of its range above,
/// has no load, or does not know the h / l_c of `ice`; elsewhere `fast` gives the answer.
std::unique_ptr<BendingCriterion> make_screened_criterion(std::unique_ptr<BendingCriterion> fast,
                                                          std::unique_ptr<BendingCriterion> exact,
                                                          const IceProperties& ice, double margin);

/// Throws ContractViolation when `load` is not a load case.
void expect_valid(const LoadCase& load);

/// The pressure of a contact that is widened from `wanted` to `used` contact lengths [Pa]. It keeps its force p c h,
/// unless the options say that it keeps p: far from the tip only the force counts.
double widened_pressure(double pressure, double wanted, double used, const BendingOptions& options);

/// N / sqrt(k D) of a contact's pressure [Pa] where the second order is asked for, else 0.
double in_plane_load(const IceProperties& ice, double l_c, double pressure, const BendingOptions& options);

}  // namespace brash::failure
