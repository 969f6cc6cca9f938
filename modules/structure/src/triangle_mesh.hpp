// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "brash/structure/hull.hpp"

namespace brash::structure {

/// A box along the axes [m]; without points nothing is in it.
struct Box {
  Vec3 least{HUGE_VAL, HUGE_VAL, HUGE_VAL}, most{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  void add(Vec3 p) {
    least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
    most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
  }
  Vec3 size() const { return most - least; }
  double extent() const { return norm(size()); }  ///< length of its diagonal [m]
  Vec3 middle() const { return 0.5 * (least + most); }
};

inline Box box_around(std::span<const Vec3> points) {
  Box box;
  for (const Vec3 p : points) box.add(p);
  return box;
}

/// The three corners of triangle `t` [m].
inline std::array<Vec3, 3> corners(const TriangleMesh& mesh, std::size_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return {mesh.vertices[static_cast<std::size_t>(a)], mesh.vertices[static_cast<std::size_t>(b)],
          mesh.vertices[static_cast<std::size_t>(c)]};
}

/// Area of a triangle times its unit normal [m2].
inline Vec3 vector_area(const std::array<Vec3, 3>& triangle) {
  return 0.5 * cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
}

/// The triangles of a mesh that `keep` holds for, and their vertices.
template <typename Keep>
TriangleMesh part_of(const TriangleMesh& mesh, Keep keep) {
  TriangleMesh part;
  std::vector<int> number(mesh.vertices.size(), -1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!keep(t)) continue;
    std::array<int, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto old = static_cast<std::size_t>(mesh.triangles[t][k]);
      if (number[old] < 0) {
        number[old] = static_cast<int>(part.vertices.size());
        part.vertices.push_back(mesh.vertices[old]);
      }
      triangle[k] = number[old];
    }
    part.triangles.push_back(triangle);
  }
  return part;
}

/// Volume of a closed mesh, negative when its triangles face inwards [m3].
double signed_volume(const TriangleMesh& mesh);

/// Number of the shell of each triangle, from 0, and the number of shells. Triangles of one shell hang together by
/// common vertices.
std::pair<std::vector<int>, int> shells_of(const TriangleMesh& mesh);

/// The triangle across each edge of each triangle; edge k joins corner k to the next one. The mesh is closed.
std::vector<std::array<int, 3>> neighbours_of(const TriangleMesh& mesh);

/// The distance of a point from a triangle [m].
double distance(Vec3 point, const std::array<Vec3, 3>& triangle);

}  // namespace brash::structure
