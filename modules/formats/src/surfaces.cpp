// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include "brash/formats/vtk.hpp"

namespace brash::formats {
namespace {

/// The points of one prism: a lower and an upper one over each vertex of the plan.
class Corners {
 public:
  Corners(PolyData& data, double bottom, double top, const Pose& pose)
      : data_(data), bottom_(bottom), top_(top), pose_(pose) {}

  /// Index of the lower point over `vertex`; the upper one comes next.
  std::int64_t at(geometry::Point vertex) {
    const auto next = static_cast<std::int64_t>(data_.points.size());
    const auto [place, is_new] = known_.try_emplace(vertex, next);
    if (is_new) {
      const Vec2 v = geometry::metres(vertex);
      data_.points.push_back(to_world(pose_, {v.x, v.y, bottom_}));
      data_.points.push_back(to_world(pose_, {v.x, v.y, top_}));
    }
    return place->second;
  }

 private:
  PolyData& data_;
  double bottom_;
  double top_;
  Pose pose_;
  std::map<geometry::Point, std::int64_t> known_;
};

void add_sides(PolyData& data, Corners& corners, const geometry::Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::int64_t a = corners.at(ring[i]), b = corners.at(ring[(i + 1) % ring.size()]);
    data.faces.push_back({a, b, b + 1, a + 1});
  }
}

}  // namespace

std::size_t add_prism(PolyData& data, const geometry::Polygon& polygon, double bottom, double top, const Pose& pose) {
  const std::size_t before = data.faces.size();
  Corners corners(data, bottom, top, pose);
  for (const geometry::Ring& part : geometry::convex_parts(polygon)) {
    std::vector<std::int64_t> lower, upper;
    for (const geometry::Point vertex : part) {
      lower.push_back(corners.at(vertex));
      upper.push_back(lower.back() + 1);
    }
    std::ranges::reverse(lower);
    data.faces.push_back(std::move(lower));
    data.faces.push_back(std::move(upper));
  }
  add_sides(data, corners, polygon.outline);
  for (const geometry::Ring& hole : polygon.holes) add_sides(data, corners, hole);
  return data.faces.size() - before;
}

PolyData sheet_surface(const model::Case& resolved, const std::vector<geometry::Polygon>& polygons) {
  PolyData data;
  const double top = resolved.ice.thickness * (1.0 - resolved.ice.density / resolved.water.density);
  for (const geometry::Polygon& polygon : polygons) add_prism(data, polygon, top - resolved.ice.thickness, top);
  return data;
}

PolyData mesh_surface(const structure::TriangleMesh& mesh, const Pose& pose) {
  PolyData data;
  for (const Vec3& vertex : mesh.vertices) data.points.push_back(to_world(pose, vertex));
  for (const auto& [a, b, c] : mesh.triangles) data.faces.push_back({a, b, c});
  return data;
}

}  // namespace brash::formats
