// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <tl/expected.hpp>

namespace brash::io {

/// Numbers of one unit in another. Units are linear in each other, so 0 and 1 are enough; `value` is converted at once.
struct InOtherUnit {
  double zero = 0.0, one = 0.0, value = 0.0;
};

enum class UnitFault {
  kUnknown,     ///< of the unit that is given
  kOtherKind,   ///< such as a length where a time is asked for, or a ratio where an angle is
  kNoConverter  ///< the library knows none
};

/// `value`, given in the unit spelled `from`, in the unit spelled `to`; from UDUNITS-2.
/// @throws InputError when its database cannot be read.
tl::expected<InOtherUnit, UnitFault> in_unit_of_udunits(double value, const std::string& from, const std::string& to);

/// The same from a table of the usual units, for the simulator in a page: it has no files and no UDUNITS-2. Spellings
/// are those that read_quantity() lets pass. Each unit that it knows has the factor of UDUNITS-2.
tl::expected<InOtherUnit, UnitFault> in_unit_of_table(double value, const std::string& from, const std::string& to);

}  // namespace brash::io
