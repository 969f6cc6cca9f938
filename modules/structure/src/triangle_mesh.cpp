// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangle_mesh.hpp"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <numeric>
#include <tuple>

#include "brash/core/contract.hpp"

namespace brash::structure {

double signed_volume(const TriangleMesh& mesh) {
  const Vec3 apex = mesh.vertices.empty() ? Vec3{} : mesh.vertices.front();
  double volume = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = corners(mesh, t);
    volume += dot(a - apex, cross(b - apex, c - apex)) / 6.0;
  }
  return volume;
}

std::pair<std::vector<int>, int> shells_of(const TriangleMesh& mesh) {
  std::vector<int> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int v) {
    while (parent[static_cast<std::size_t>(v)] != v) {
      int& up = parent[static_cast<std::size_t>(v)];
      v = up = parent[static_cast<std::size_t>(up)];
    }
    return v;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    parent[static_cast<std::size_t>(root(b))] = root(a);
    parent[static_cast<std::size_t>(root(c))] = root(a);
  }
  std::vector<int> number(mesh.vertices.size(), -1), shells;
  int n = 0;
  for (const auto& triangle : mesh.triangles) {
    int& known = number[static_cast<std::size_t>(root(triangle[0]))];
    if (known < 0) known = n++;
    shells.push_back(known);
  }
  return {std::move(shells), n};
}

std::vector<std::array<int, 3>> neighbours_of(const TriangleMesh& mesh) {
  struct Side {
    int from, to, triangle, edge;
  };
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto& corner = mesh.triangles[t];
      sides.push_back(
          {corner[static_cast<std::size_t>(k)], corner[static_cast<std::size_t>((k + 1) % 3)], static_cast<int>(t), k});
    }
  const auto key = [](const Side& s) { return std::tuple(std::min(s.from, s.to), std::max(s.from, s.to)); };
  std::ranges::sort(sides, {}, [&](const Side& s) { return std::tuple_cat(key(s), std::tuple(s.triangle)); });
  BRASH_EXPECTS(sides.size() % 2 == 0, sides.size());
  std::vector<std::array<int, 3>> neighbours(mesh.triangles.size());
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
    const Side &one = sides[i], &other = sides[i + 1];
    BRASH_EXPECTS(one.from == other.to && one.to == other.from, one.from, one.to, "the mesh is not closed");
    neighbours[static_cast<std::size_t>(one.triangle)][static_cast<std::size_t>(one.edge)] = other.triangle;
    neighbours[static_cast<std::size_t>(other.triangle)][static_cast<std::size_t>(other.edge)] = one.triangle;
  }
  return neighbours;
}

double distance(Vec3 point, const std::array<Vec3, 3>& triangle) {
  using Kernel = CGAL::Simple_cartesian<double>;
  const auto of = [](Vec3 v) { return Kernel::Point_3(v.x, v.y, v.z); };
  return std::sqrt(
      CGAL::squared_distance(of(point), Kernel::Triangle_3(of(triangle[0]), of(triangle[1]), of(triangle[2]))));
}

}  // namespace brash::structure
