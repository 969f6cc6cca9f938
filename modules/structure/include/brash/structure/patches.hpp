// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "brash/structure/hull.hpp"

namespace brash::structure {

/// A part of one side of a hull.
struct Patch {
  Vec3 normal{};           ///< unit, out of the hull
  double plan_area = 0.0;  ///< of its plan [m2]
  double area = 0.0;       ///< of itself [m2]
  Vec3 centroid{};         ///< [m]
};

/// The parts of the sides whose plan lies in `region`. A vertical side has no plan, so it has no part.
/// @param sides   Hull::sides().
/// @param region  rings of a polygon of the plan [m]: outline counter-clockwise, holes clockwise.
std::vector<Patch> patches_within(std::span<const SidePiece> sides, std::span<const std::vector<Vec2>> region);

}  // namespace brash::structure
