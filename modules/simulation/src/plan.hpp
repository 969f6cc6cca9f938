// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "brash/geometry/polygon.hpp"

namespace brash::simulation {

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

}  // namespace brash::simulation
