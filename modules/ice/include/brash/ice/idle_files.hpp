// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brash/failure/criterion.hpp"
#include "brash/geometry/ice_sheet.hpp"
#include "brash/model/case.hpp"

namespace brash::ice {

/// A file of [field] that leaves the level ice as it is, or nearly: most often it lies somewhere else.
struct IdleFile {
  std::string key;         ///< `openings`, `cracks` or `shore`
  double taken = 0.0;      ///< area that it takes away [m2]
  geometry::Extent reach;  ///< around what it holds, sheet frame [m]
  geometry::Extent ice;    ///< around the ice that it should change, sheet frame [m]
};

/// Lays the level ice of `field`, and says which of its files do nothing there: openings that take away less than the
/// square of the ice's thickness, a shore that also holds no ice, and lines that part none.
/// @param ice  as of a case.
/// @return none without such files, or for a field of floes.
/// @throws InputError when the ice cannot be laid: file and place.
std::vector<IdleFile> idle_files(const model::FieldSection& field, const failure::IceProperties& ice);

}  // namespace brash::ice
