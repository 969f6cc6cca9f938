// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace brash::geometry {

/// Has exact numbers throw std::bad_alloc where memory is short: GMP ends the process otherwise. To be called before
/// the first of them is made. Functions that another library has given GMP stay.
void throw_where_memory_is_short();

}  // namespace brash::geometry
