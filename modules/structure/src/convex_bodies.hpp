// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/structure/hull.hpp"

namespace brash::structure {

/// Convex bodies in place of a closed mesh.
struct ConvexBodies {
  std::vector<ConvexPart> parts;
  double error = 0.0;  ///< their volume beyond the mesh's and short of it, over the mesh's volume [-]
};

/// One body for each shell that is nearly convex. The others are cut by planes along their axes, each time the part
/// that sticks out most, until the parts' volume is right or there are too many parts.
ConvexBodies convex_bodies(const TriangleMesh& mesh);

}  // namespace brash::structure
