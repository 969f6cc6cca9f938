// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace brash::io {

/// A short case to begin with: the keys that a structure of this kind requires, with the values of the validation case
/// or of the schema's examples.
/// @param kind  as structure.kind.
/// @throws InputError when there is no such kind.
std::string new_case(const std::string& kind);

}  // namespace brash::io
