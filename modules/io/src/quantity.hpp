// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace brash::io {

/// Why a quantity could not be read, and the remedy.
struct QuantityError {
  std::string what;
  std::string remedy;
};

/// Reads a quantity such as "33 cm" and converts it to `unit` (UDUNITS-2 syntax, "1" for ratios).
///
/// Differs from UDUNITS where that would be silently wrong: nmi is the nautical mile (1852 m, not a nano-mile), ppt is
/// parts per thousand (not per trillion), deg is the degree of arc; fractional exponents ("m^0.5", which UDUNITS reads
/// as 5 m^0) and numbers within the unit are refused; angles and pure ratios do not convert into each other.
tl::expected<double, QuantityError> read_quantity(const std::string& text, const std::string& unit);

/// Units that people use for quantities of the unit `unit`, the likeliest first; none for ratios.
const std::vector<std::string>& usual_units(const std::string& unit);

}  // namespace brash::io
