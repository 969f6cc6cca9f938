// SPDX-License-Identifier: GPL-3.0-or-later
#include "hull_triangles.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <map>

namespace brash::rigid_body {

std::vector<std::array<int, 3>> hull_triangles(std::span<const Vec3> points) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  std::vector<Point> cloud;
  std::map<Point, int> number;
  for (const Vec3& p : points) {
    cloud.emplace_back(p.x, p.y, p.z);
    number.emplace(cloud.back(), static_cast<int>(number.size()));
  }
  CGAL::Surface_mesh<Point> surface;
  CGAL::convex_hull_3(cloud.begin(), cloud.end(), surface);
  std::vector<std::array<int, 3>> triangles;
  for (const auto f : surface.faces()) {
    auto h = surface.halfedge(f);
    if (surface.is_border(surface.opposite(h))) return {};
    std::array<int, 3> triangle{};
    for (int& corner : triangle) {
      corner = number.at(surface.point(surface.target(h)));
      h = surface.next(h);
    }
    if (surface.next(surface.next(surface.next(surface.halfedge(f)))) != surface.halfedge(f)) return {};
    std::rotate(triangle.begin(), std::ranges::min_element(triangle), triangle.end());
    triangles.push_back(triangle);
  }
  std::ranges::sort(triangles);  // the order of CGAL depends on addresses
  return triangles;
}

}  // namespace brash::rigid_body
