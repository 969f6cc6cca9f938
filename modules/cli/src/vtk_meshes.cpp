// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk_meshes.hpp"

#include <algorithm>
#include <map>

namespace brash::cli {
namespace {

/// The points of one prism: a lower and an upper one over each vertex of the plan.
class Corners {
 public:
  Corners(io::PolyData& data, double bottom, double top, const Pose& pose)
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
  io::PolyData& data_;
  double bottom_;
  double top_;
  Pose pose_;
  std::map<geometry::Point, std::int64_t> known_;
};

void add_sides(io::PolyData& data, Corners& corners, const geometry::Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::int64_t a = corners.at(ring[i]), b = corners.at(ring[(i + 1) % ring.size()]);
    data.faces.push_back({a, b, b + 1, a + 1});
  }
}

}  // namespace

std::size_t add_prism(io::PolyData& data, const geometry::Polygon& polygon, double bottom, double top,
                      const Pose& pose) {
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

std::vector<geometry::Polygon> polygons_of(std::span<const std::vector<Vec2>> rings) {
  std::vector<geometry::Polygon> polygons;
  for (const std::vector<Vec2>& vertices : rings) {
    geometry::Ring ring;
    for (const Vec2 v : vertices) ring.push_back(geometry::snap(v));
    if (polygons.empty() || geometry::signed_area(ring) > geometry::ExactArea{})
      polygons.push_back({std::move(ring), {}});
    else
      polygons.back().holes.push_back(std::move(ring));
  }
  return polygons;
}

}  // namespace brash::cli
