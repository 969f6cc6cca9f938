// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace brash {

/// A quantity in the unit that keeps it short: 0.33 m is "33 cm", 3.5e8 Pa is "350 MPa".
/// @param value  SI.
/// @param unit   of UDUNITS, such as "kg m-3"; "1" where there is none.
std::string quantity_text(double value, const std::string& unit);

}  // namespace brash
