// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/geometry/polygon.hpp"

namespace brash::geometry {

/// The simple loops that a closed chain with repeated vertices consists of.
std::vector<Ring> simple_loops(Ring ring);

/// The connected region whose boundary is these chains, the region on their left.
///
/// Chains may come through a vertex more than once. Each ring starts at its smallest vertex, and the holes are sorted.
Polygon polygon_of(const std::vector<Ring>& boundary);

}  // namespace brash::geometry
