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
  Integral(const Waterplane& plane, const Twist& relative, const Water& water, Shade& shade)
      : plane_(plane),
        relative_(relative),
        form_(0.5 * water.density * water.form_drag),
        skin_(0.5 * water.density * water.skin_friction),
        shade_(shade) {}

  /// A flat convex face, corners counter-clockwise or clockwise.
  void add(std::span<const Vec3> corners, Vec3 normal) {
    if (std::ranges::all_of(corners, [&](Vec3 p) { return plane_.height(p) >= 0.0; })) return;
    turn_shade(corners, normal);
    if (corners.size() == 4) {
      add({{corners[0], corners[1], corners[2], corners[3]}, 4}, normal);
    } else {
      for (std::size_t i = 2; i < corners.size(); ++i) add({{corners[0], corners[i - 1], corners[i]}, 3}, normal);
    }
  }

  SurfaceDrag result;

 private:
  void turn_shade(std::span<const Vec3> corners, Vec3 normal) {
    Vec3 centre{};
    for (const Vec3 corner : corners) centre += corner / static_cast<double>(corners.size());
    double square = 0.0;
    for (const Vec3 corner : corners) square = std::max(square, dot(corner - centre, corner - centre));
    shade_.face(centre, normal, std::sqrt(square));
  }

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

  void add_side(const Piece& piece, Vec3 normal, bool leads) {
    if (!leads && skin_ == 0.0) return;
    for (std::size_t i = 2; i < piece.n; ++i)
      for_each_point(piece.corners[0], piece.corners[i - 1], piece.corners[i], [&](Vec3 point, double weight) {
        const double share = weight * shade_.open_share(point);
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
  Shade& shade_;
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

void Shade::face(Vec3 centre, Vec3 normal, double radius) {
  planes_.clear();
  ends_.clear();
  if (near_.empty()) return;
  const Vec3 axis = rotate(pose_.rotation, normal);
  const Vec3 middle = to_world(pose_, centre) + gap_ * axis;
  const Quaternion to_axes = conjugate(pose_.rotation);
  for (const Solid solid : near_) {
    const std::size_t first = planes_.size();
    bool apart = false;
    for (const Plane& plane : solid) {
      // The probes lie on a disc, which reaches radius times the sine of the angle to its axis along another direction.
      const double distance = dot(plane.normal, middle) - plane.offset;
      const double cosine = dot(plane.normal, axis);
      const double off = std::abs(distance) - 0.5 * gap_;
      if (off > 0.0 && off * off > radius * radius * (1.0 - cosine * cosine)) {
        apart = distance > 0.0;
        if (apart) break;
        continue;  // all probes are well inside
      }
      const Vec3 n = rotate(to_axes, plane.normal);
      planes_.push_back({n, dot(n, centre) - distance});
    }
    planes_.resize(apart ? first : planes_.size());
    if (!apart) ends_.push_back(planes_.size());
  }
}

double Shade::open_share(Vec3 point) const {
  double held = 0.0;
  std::size_t i = 0;
  for (const std::size_t end : ends_) {
    double share = 1.0;
    for (; i < end; ++i) share = std::min(share, 0.5 - (dot(planes_[i].normal, point) - planes_[i].offset) / gap_);
    held += std::max(0.0, share);
  }
  return std::max(0.0, 1.0 - held);
}

SurfaceDrag surface_drag(const Prism& prism, const Waterplane& plane, const Twist& relative, const Water& water,
                         Shade shade) {
  Integral integral(plane, relative, water, shade);
  const double half = 0.5 * prism.thickness;
  std::vector<Vec3> corners;
  for (const double side : {-1.0, 1.0}) {
    for (const auto& part : prism.parts) {
      corners.clear();
      for (const Vec2 vertex : part) corners.push_back({vertex.x, vertex.y, side * half});
      integral.add(corners, {0.0, 0.0, side});
    }
  }
  for (const auto& ring : prism.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 from = ring[i == 0 ? ring.size() - 1 : i - 1], to = ring[i];
      const double length = norm(to - from);
      if (length == 0.0) continue;
      const Vec2 out = -perpendicular(to - from) / length;
      const std::array<Vec3, 4> face{Vec3{from.x, from.y, -half}, Vec3{to.x, to.y, -half}, Vec3{to.x, to.y, half},
                                     Vec3{from.x, from.y, half}};
      integral.add(face, {out.x, out.y, 0.0});
    }
  }
  return integral.result;
}

}  // namespace brash::hydrodynamics
