// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
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

/// Axis-parallel; without ice `lower` exceeds `upper`.
struct Box {
  Vec2 lower{};
  Vec2 upper{};
};

inline Box bounding_box(std::span<const geometry::Polygon> polygons) {
  Box box{{1e300, 1e300}, {-1e300, -1e300}};
  for (const geometry::Polygon& polygon : polygons) {
    for (const geometry::Point point : polygon.outline) {
      const Vec2 v = geometry::metres(point);
      box.lower = {std::min(box.lower.x, v.x), std::min(box.lower.y, v.y)};
      box.upper = {std::max(box.upper.x, v.x), std::max(box.upper.y, v.y)};
    }
  }
  return box;
}

}  // namespace brash::simulation
