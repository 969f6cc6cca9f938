// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brash/model/case.hpp"

namespace brash::fmu {

/// A number of a case that a host may set before it initialises a unit.
struct Parameter {
  std::string section, key;  ///< as in a case file
  std::string unit;          ///< UDUNITS; "1" where there is none
  std::string meaning;
  double least = 0.0, most = 0.0;  ///< both allowed, SI
};

/// A case that other programs step: a functional mock-up unit for co-simulation (FMI).
struct Unit {
  /// A model file of its own is named relative to the unit's resources.
  model::Case resolved;
  std::vector<Parameter> parameters;
  std::string token;                 ///< a host states it, so that description and library fit each other
  bool velocity_from_poses = false;  ///< of a driven structure: its velocities are no inputs
};

/// The file in a unit's resources that unit_from() reads; beside it stands the folder of the models.
inline constexpr const char* kUnitFile = "unit.json";
inline constexpr const char* kModelFolder = "models";

std::string to_json(const Unit& unit);

/// @param text  from to_json().
/// @param path  its file, for messages.
/// @throws InputError naming `path`.
Unit unit_from(const std::string& text, const std::string& path);

}  // namespace brash::fmu
