// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "free_edges.hpp"
#include "noding.hpp"

namespace brash::geometry {

/// The edges that bound the ice inside the region, with this ice on their left: free edges inside the region, and edges
/// of the region inside the ice. An edge of both counts as a free edge.
///
/// The direction of the free edges at a node decides, and a chain without such a node is decided once.
/// @throws ContractViolation when the region is not simple.
std::vector<NodedEdge> overlap_edges(const Noding& noding, const FreeEdges& boundary);

}  // namespace brash::geometry
