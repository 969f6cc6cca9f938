// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace brash::io {

/// A short case to begin with: the keys that a structure of this kind requires, with the values of the validation case
/// or of the schema's examples.
/// @param kind  as structure.kind.
/// @param ice   one of site_ice(): the ice and the water of a site, each value with its source in a comment.
/// @throws InputError when there is no such kind or ice.
std::string new_case(const std::string& kind, const std::string& ice = "basin");

/// The names of the ice that templates offer: "basin", the model ice of the validation case, and the sites.
std::vector<std::string> site_ice();

}  // namespace brash::io
