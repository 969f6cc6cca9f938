// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "brash/model/case.hpp"
#include "brash/model/origin.hpp"

namespace brash::io {

/// Of a case that this program reads: its preset and this version.
///
/// A key of the preset counts as changed when its value is not the one that the preset gives. The keys are those with
/// `x-presets` in the schema.
model::Origin origin_of(const model::Case& resolved);

/// The same from a file of a run: the case in it, and the version that made it. Empty for other and for missing files.
/// @param path  a manifest.json or a run.nc.
model::Origin origin_in(const std::string& path);

/// One line for a table: "preset: paper (2 keys changed); program: brash 0.2.0". Several presets or programs are all
/// named. Text from files cannot steer a terminal. Without an origin the line is "".
std::string origin_line(const model::Origin& origin);

}  // namespace brash::io
