// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include "broad_phase.hpp"
#include "overlap.hpp"

namespace brash::rigid_body {

/// Where and how two parts touch. Looks at the present poses only: no history, so a step is a function of the state.
class NarrowPhase {
 public:
  /// Whether the parts overlap; then `normal` and `patch` describe how.
  bool find(const PartPair& pair);

  Vec3 normal{};  ///< unit, from the second part into the first
  Patch patch;

 private:
  Vec3 direction(const PartPair& pair, const Overlap& overlap);

  OverlapFinder finder_;
  btVoronoiSimplexSolver simplex_;
  btGjkEpaPenetrationDepthSolver epa_;
};

}  // namespace brash::rigid_body
