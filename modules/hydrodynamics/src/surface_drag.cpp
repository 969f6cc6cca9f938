// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_drag.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace brash::hydrodynamics {
namespace {

/// A flat convex piece of the surface; a triangle or quadrilateral cut by two planes has at most six corners.
struct Piece {
  std::array<Vec3, 6> corners{};
  std::size_t n = 0;

  void add(Vec3 corner) { corners[n++] = corner; }
};

/// The part of `piece` where `value`, linear in the point, is negative.
template <typename Value>
Piece where_negative(const Piece& piece, Value value) {
  Piece part;
  for (std::size_t i = 0; i < piece.n; ++i) {
    const Vec3 a = piece.corners[i], b = piece.corners[i + 1 == piece.n ? 0 : i + 1];
    const double at_a = value(a), at_b = value(b);
    if (at_a <= 0.0) part.add(a);
    if ((at_a < 0.0 && at_b > 0.0) || (at_a > 0.0 && at_b < 0.0)) part.add(waterline_point(a, at_a, b, at_b));
  }
  return part;
}

/// Calls `visit(point, weight)` for the four points of Stroud's conical product rule on the triangle: positive weights,
/// exact for polynomials of degree 3. The weights sum to the area.
template <typename Visit>
void for_each_point(Vec3 a, Vec3 b, Vec3 c, Visit visit) {
  // Gauss-Jacobi for the weight 1 - u and Gauss-Legendre on [0, 1], two points each.
  static constexpr std::array<double, 2> kU{0.15505102572168219, 0.64494897427831781};
  static constexpr std::array<double, 2> kUWeight{0.31804138174397717, 0.18195861825602283};
  static constexpr std::array<double, 2> kV{0.21132486540518712, 0.78867513459481288};
  const double area = 0.5 * norm(cross(b - a, c - a));
  for (std::size_t i = 0; i < 2; ++i)
    for (const double v : kV) visit(a + (1.0 - kU[i]) * ((1.0 - v) * (b - a) + v * (c - a)), area * kUWeight[i]);
}

/// Sums the drag of one piece of the surface after another.
class Integral {
 public:
  Integral(const Waterplane& plane, const Twist& relative, const Water& water, const Shade& shade)
      : plane_(plane),
        relative_(relative),
        form_(0.5 * water.density * water.form_drag),
        skin_(0.5 * water.density * water.skin_friction),
        shade_(shade) {}

  void add(const Piece& whole, Vec3 normal) {
    const Piece wet = where_negative(whole, [&](Vec3 p) { return plane_.height(p); });
    if (wet.n < 3) return;
    // Where the surface moves against its normal it is on the lee side: no form drag there.
    const auto against = [&](Vec3 p) { return -dot(normal, velocity_at(relative_, p)); };
    bool leads = false, lees = false;
    for (std::size_t i = 0; i < wet.n; ++i) {
      const double speed = against(wet.corners[i]);
      leads |= speed < 0.0;
      lees |= speed > 0.0;
    }
    if (leads && lees) {
      add_side(where_negative(wet, against), normal, true);
      add_side(where_negative(wet, [&](Vec3 p) { return -against(p); }), normal, false);
    } else {
      add_side(wet, normal, leads);
    }
  }

  SurfaceDrag result;

 private:
  void add_side(const Piece& piece, Vec3 normal, bool leads) {
    if (!leads && skin_ == 0.0) return;
    for (std::size_t i = 2; i < piece.n; ++i)
      for_each_point(piece.corners[0], piece.corners[i - 1], piece.corners[i], [&](Vec3 point, double weight) {
        const double share = weight * shade_.open_share(point, normal);
        const Vec3 velocity = velocity_at(relative_, point);
        const double outwards = dot(velocity, normal);
        if (leads) result.form.add(share * form_ * std::max(0.0, outwards), point);
        const Vec3 along = velocity - outwards * normal;
        const Vec3 force = -share * skin_ * norm(along) * along;
        result.skin_friction += {force, cross(point, force)};
      });
  }

  const Waterplane& plane_;
  const Twist& relative_;
  double form_;
  double skin_;
  const Shade& shade_;
};

}  // namespace

Shade::Shade(const Prism& prism, const Pose& pose, std::span<const Solid> neighbours, double gap)
    : pose_(pose), gap_(gap) {
  if (gap <= 0.0 || neighbours.empty()) return;
  double radius = 0.0;
  for (const Vec2 vertex : prism.rings.front()) radius = std::max(radius, norm(vertex));
  const double reach = radius + 0.5 * prism.thickness + kShadingReach * gap;
  for (const Solid solid : neighbours)
    if (signed_distance(solid, pose.position) < reach) near_.push_back(solid);
}

double Shade::open_share(Vec3 point, Vec3 normal) const {
  if (near_.empty()) return 1.0;
  const Vec3 probe = to_world(pose_, point + gap_ * normal);
  double held = 0.0;
  for (const Solid solid : near_) held += std::clamp(0.5 - signed_distance(solid, probe) / gap_, 0.0, 1.0);
  return std::max(0.0, 1.0 - held);
}

SurfaceDrag surface_drag(const Prism& prism, const Waterplane& plane, const Twist& relative, const Water& water,
                         const Shade& shade) {
  Integral integral(plane, relative, water, shade);
  const double half = 0.5 * prism.thickness;
  for (const double side : {-1.0, 1.0}) {
    for (const auto& part : prism.parts) {
      const auto corner = [&](std::size_t i) { return Vec3{part[i].x, part[i].y, side * half}; };
      for (std::size_t i = 2; i < part.size(); ++i)
        integral.add({{corner(0), corner(i - 1), corner(i)}, 3}, {0.0, 0.0, side});
    }
  }
  for (const auto& ring : prism.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 from = ring[i == 0 ? ring.size() - 1 : i - 1], to = ring[i];
      const double length = norm(to - from);
      if (length == 0.0) continue;
      const Vec2 out = -perpendicular(to - from) / length;
      integral.add({{Vec3{from.x, from.y, -half}, {to.x, to.y, -half}, {to.x, to.y, half}, {from.x, from.y, half}}, 4},
                   {out.x, out.y, 0.0});
    }
  }
  return integral.result;
}

}  // namespace brash::hydrodynamics
