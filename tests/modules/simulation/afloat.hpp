// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/edge/edge_contact.hpp"
#include "brash/ice/plate.hpp"

namespace brash::simulation::testing {

/// A plate of the case's ice with this outline [m].
inline ice::Plate afloat(const model::Case& resolved, const std::vector<Vec2>& outline) {
  return {0, ice::Hold::kAfloat, edge::ice_properties(resolved), {{geometry::ring(outline), {}}}};
}

}  // namespace brash::simulation::testing
