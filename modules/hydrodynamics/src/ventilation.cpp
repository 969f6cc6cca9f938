// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/hydrodynamics/ventilation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "brash/core/constants.hpp"
#include "plan_rectangle.hpp"
#include "wetted_faces.hpp"

namespace brash::hydrodynamics {
namespace {

/// Integrals over the sunk part of the upper face of 1, the depth d and d times the place.
struct DepthIntegrals {
  double area = 0.0;
  double depth = 0.0;  ///< [m3]
  Vec3 moment{};       ///< [m4], body frame

  /// Over the triangle abc, whose depths are linear in the place; its orientation counts.
  void add(Vec3 a, Vec3 b, Vec3 c, const Waterplane& water) {
    const double triangle = 0.5 * cross(plan(b - a), plan(c - a));
    const double da = -water.height(a), db = -water.height(b), dc = -water.height(c);
    const double sum = da + db + dc;
    area += triangle;
    depth += triangle / 3.0 * sum;
    moment += triangle / 12.0 * (da * a + db * b + dc * c + sum * (a + b + c));
  }
};

/// The vertices of a face that lie lowest and highest.
struct Extremes {
  Vec3 lowest{}, highest{};
  double least = 0.0, most = 0.0;  ///< their heights [m]
};

Extremes extremes(const Prism& prism, double z, const Waterplane& water) {
  Extremes e;
  bool first = true;
  for (const auto& ring : prism.rings)
    for (const Vec2 vertex : ring) {
      const Vec3 p{vertex.x, vertex.y, z};
      const double height = water.height(p);
      if (first || height < e.least) e.lowest = p, e.least = height;
      if (first || height > e.most) e.highest = p, e.most = height;
      first = false;
    }
  return e;
}

/// As wetted_plan_face(): the edges, each clipped on its own, and a point on the waterline.
DepthIntegrals integrals_below(const Prism& prism, double z, const Extremes& e, const Waterplane& water) {
  const bool clipped = e.most > 0.0;
  const Vec3 reference = clipped ? waterline_point(e.lowest, e.least, e.highest, e.most) : e.lowest;
  DepthIntegrals sum;
  for (const auto& ring : prism.rings) {
    Vec3 a{ring.back().x, ring.back().y, z};
    double height_a = water.height(a);
    for (const Vec2 vertex : ring) {
      const Vec3 b{vertex.x, vertex.y, z};
      const double height_b = water.height(b);
      if (!clipped || height_a < 0.0 || height_b < 0.0) {
        const Vec3 from = height_a > 0.0 ? waterline_point(a, height_a, b, height_b) : a;
        const Vec3 to = height_b > 0.0 ? waterline_point(b, height_b, a, height_a) : b;
        sum.add(reference, from, to, water);
      }
      a = b;
      height_a = height_b;
    }
  }
  return sum;
}

}  // namespace

SunkTop sunk_top(const Prism& prism, const Pose& pose, double density) {
  const Waterplane water = waterplane_in_body_frame(pose);
  const bool looks_down = water.up.z <= 0.0;
  const double z = 0.5 * prism.thickness;
  const Extremes e = extremes(prism, z, water);
  if (e.least >= 0.0) return {.looks_down = looks_down};
  const PlanRectangle sides(prism);
  const double half_side = 0.5 * std::min(sides.x, sides.y);
  if (looks_down) return {.run = half_side, .looks_down = true};
  const DepthIntegrals below = integrals_below(prism, z, e, water);
  if (!(below.area > 0.0 && below.depth > 0.0)) return {};

  // Water comes over every sunk edge: the last of it runs half the short side, or up the slope to the waterline.
  const double slope = norm(plan(water.up));
  const double up_the_slope = e.most > 0.0 ? -e.least / slope : std::numeric_limits<double>::infinity();
  const double weight = density * kGravity;
  const Vec3 force = rotate(pose.rotation, {0.0, 0.0, -weight * below.depth});
  const Vec3 arm = rotate(pose.rotation, below.moment / below.depth);
  return {.mean_depth = below.depth / below.area,
          .run = std::min(half_side, up_the_slope),
          .pressure = {force, cross(arm, force)}};
}

double ran_in_after(double ran, const SunkTop& top, double dt) {
  if (top.looks_down) return top.run;
  if (top.mean_depth == 0.0) return 0.0;
  return std::min(top.run, ran + 2.0 * std::sqrt(kGravity * top.mean_depth) * dt);
}

double flooded_share(double ran, const SunkTop& top) {
  if (top.looks_down || top.run == 0.0) return 1.0;
  return std::min(1.0, ran / top.run);
}

}  // namespace brash::hydrodynamics
