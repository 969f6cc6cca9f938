// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "brash/geometry/polygon.hpp"

namespace brash::floes {

/// Vertices in metres; shape=(n_vertices,).
inline std::vector<Vec2> to_metres(std::span<const geometry::Point> ring) {
  std::vector<Vec2> vertices;
  vertices.reserve(ring.size());
  for (const geometry::Point point : ring) vertices.push_back(geometry::metres(point));
  return vertices;
}

/// Outline and holes in metres.
inline std::vector<std::vector<Vec2>> rings_in_metres(const geometry::Polygon& polygon) {
  std::vector<std::vector<Vec2>> rings{to_metres(polygon.outline)};
  for (const geometry::Ring& hole : polygon.holes) rings.push_back(to_metres(hole));
  return rings;
}

/// Whether a place where something presses on ice belongs to the ice in a box. Overlaps reach beyond it by millimetres.
inline bool is_on(const geometry::Extent& box, Vec2 place) {
  constexpr double kOverlap = 0.01;  // m
  return place.x > box.lower.x - kOverlap && place.x < box.upper.x + kOverlap && place.y > box.lower.y - kOverlap &&
         place.y < box.upper.y + kOverlap;
}

}  // namespace brash::floes
