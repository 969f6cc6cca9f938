// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "brash/fmu/unit.hpp"

namespace brash::fmu {

/// Versions of the Functional Mock-up Interface.
enum class Standard { kFmi2 = 2, kFmi3 = 3 };

/// The name of the library in a unit, without its ending.
inline constexpr const char* kModelIdentifier = "brash";

/// The path of the library in a unit.
std::string library_path(Standard standard);

/// The text of a unit's modelDescription.xml.
/// @throws InputError when a value cannot be written under this version.
/// @see FMI 2.0.4, Sec. 2.2 and 4.3; FMI 3.0.2, Sec. 2.4 and 4.4.
std::string model_description(const Unit& unit, Standard standard);

}  // namespace brash::fmu
