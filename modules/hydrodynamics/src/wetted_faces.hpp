// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "brash/core/contract.hpp"
#include "brash/core/prism.hpp"
#include "brash/core/vec.hpp"

namespace brash::hydrodynamics {

/// The part of one flat face of a prism that lies below the waterplane, body frame.
struct WettedFace {
  double area = 0.0;   ///< [m2]
  Vec3 area_moment{};  ///< area times centroid [m3]
  Vec3 normal{};       ///< unit, outward
};

/// The waterplane in the body frame: the world height of body point p is dot(up, p) + offset.
struct Waterplane {
  Vec3 up{};            ///< world z in the body frame, unit
  double offset = 0.0;  ///< height of the body frame's origin [m]

  double height(Vec3 p) const { return dot(up, p) + offset; }
};

inline Waterplane waterplane_in_body_frame(const Pose& pose) {
  return {rotate(conjugate(pose.rotation), Vec3{0.0, 0.0, 1.0}), pose.position.z};
}

/// Point of the segment between `a` and `b` where the height is zero; the heights have opposite signs.
inline Vec3 waterline_point(Vec3 a, double height_a, Vec3 b, double height_b) {
  return a + (height_a / (height_a - height_b)) * (b - a);
}

/// The wetted part of a planar face bounded by rings at body height z, seen from above.
///
/// The wetted boundary is the clipped edges plus segments on the waterline. With the reference point on the waterline
/// the latter add nothing to area and moment, so the rings are clipped edge by edge and no polygon is ever built. This
/// holds for outlines that are not convex and for holes.
inline WettedFace wetted_plan_face(const Prism& prism, const Waterplane& water, double z, double normal_z) {
  Vec3 lowest{}, highest{};
  double lowest_height = 0.0, highest_height = 0.0;
  bool first = true;
  for (const auto& ring : prism.rings) {
    for (const Vec2 vertex : ring) {
      const Vec3 p{vertex.x, vertex.y, z};
      const double height = water.height(p);
      if (first || height < lowest_height) lowest = p, lowest_height = height;
      if (first || height > highest_height) highest = p, highest_height = height;
      first = false;
    }
  }
  WettedFace face{0.0, {}, {0.0, 0.0, normal_z}};
  if (first || lowest_height >= 0.0) return face;
  const bool clipped = highest_height > 0.0;
  const Vec3 reference = clipped ? waterline_point(lowest, lowest_height, highest, highest_height) : lowest;

  for (const auto& ring : prism.rings) {
    if (ring.empty()) continue;
    Vec3 a{ring.back().x, ring.back().y, z};
    double height_a = water.height(a);
    for (const Vec2 vertex : ring) {
      const Vec3 b{vertex.x, vertex.y, z};
      const double height_b = water.height(b);
      if (!clipped || height_a < 0.0 || height_b < 0.0) {
        Vec3 from = a, to = b;
        if (clipped && height_a > 0.0) from = waterline_point(a, height_a, b, height_b);
        if (clipped && height_b > 0.0) to = waterline_point(b, height_b, a, height_a);
        const double area = 0.5 * cross(plan(from - reference), plan(to - reference));
        face.area += area;
        face.area_moment += (area / 3.0) * (reference + from + to);
      }
      a = b;
      height_a = height_b;
    }
  }
  return face;
}

/// The wetted part of the side face along the ring's edge from `from` to `to`.
inline WettedFace wetted_side_face(Vec2 from, Vec2 to, double half_thickness, const Waterplane& water) {
  const Vec2 edge = to - from;
  const double length = std::sqrt(dot(edge, edge));
  WettedFace face{};
  if (length == 0.0) return face;
  face.normal = {edge.y / length, -edge.x / length, 0.0};
  const std::array<Vec3, 4> corners{Vec3{from.x, from.y, -half_thickness}, Vec3{to.x, to.y, -half_thickness},
                                    Vec3{to.x, to.y, half_thickness}, Vec3{from.x, from.y, half_thickness}};
  std::array<double, 4> height{};
  for (std::size_t i = 0; i < 4; ++i) height[i] = water.height(corners[i]);
  const auto [lowest, highest] = std::minmax({height[0], height[1], height[2], height[3]});
  if (lowest >= 0.0) return face;
  if (highest <= 0.0) {
    face.area = 2.0 * half_thickness * length;
    face.area_moment = 0.5 * face.area * Vec3{from.x + to.x, from.y + to.y, 0.0};
    return face;
  }

  // A half-space cuts a quadrilateral to at most five corners.
  std::array<Vec3, 5> polygon{};
  std::size_t n = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    if (height[i] <= 0.0) polygon[n++] = corners[i];
    if ((height[i] < 0.0 && height[j] > 0.0) || (height[i] > 0.0 && height[j] < 0.0)) {
      polygon[n++] = waterline_point(corners[i], height[i], corners[j], height[j]);
    }
  }
  for (std::size_t i = 2; i < n; ++i) {
    const double area = 0.5 * dot(face.normal, cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]));
    face.area += area;
    face.area_moment += (area / 3.0) * (polygon[0] + polygon[i - 1] + polygon[i]);
  }
  return face;
}

inline void expect_solid(const Prism& prism) {
  BRASH_EXPECTS(!prism.rings.empty() && prism.rings.front().size() >= 3, prism.rings.size());
  BRASH_EXPECTS(prism.thickness > 0.0, prism.thickness);
}

/// Calls `visit` with each outer face of a prism that has a part below the waterplane: bottom, top, then the sides in
/// the order of the rings.
template <typename Visit>
void for_each_wetted_face(const Prism& prism, const Waterplane& water, Visit visit) {
  const auto pass = [&](const WettedFace& face) {
    if (face.area > 0.0) visit(face);
  };
  const double half_thickness = 0.5 * prism.thickness;
  for (const double side : {-1.0, 1.0}) pass(wetted_plan_face(prism, water, side * half_thickness, side));
  for (const auto& ring : prism.rings) {
    if (ring.empty()) continue;
    Vec2 from = ring.back();
    for (const Vec2 to : ring) {
      pass(wetted_side_face(from, to, half_thickness, water));
      from = to;
    }
  }
}

}  // namespace brash::hydrodynamics
