// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_drag.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace brash::hydrodynamics {
namespace {

/// A flat convex piece of the surface; a triangle or quadrilateral cut by two planes has at most six corners.
struct Piece {
  std::array<Vec3, 6> corners{};
  std::size_t n = 0;

  void add(Vec3 corner) { corners[n++] = corner; }
};

/// Whether a quantity, linear over a piece, is negative, or positive, somewhere on it.
struct Signs {
  bool negative = false;
  bool positive = false;
  bool both() const { return negative && positive; }
};

template <typename Value>
Signs signs(std::span<const Vec3> corners, Value value) {
  Signs s;
  for (const Vec3 corner : corners) {
    const double at = value(corner);
    s.negative |= at < 0.0;
    s.positive |= at > 0.0;
  }
  return s;
}

/// The part of `piece` where `value`, linear in the point, is negative.
template <typename Value>
Piece where_negative(const Piece& piece, Value value) {
  Piece part;
  Vec3 a = piece.corners[0];
  double at_a = value(a);
  for (std::size_t i = 0; i < piece.n; ++i) {
    const Vec3 b = piece.corners[i + 1 == piece.n ? 0 : i + 1];
    const double at_b = value(b);
    if (at_a <= 0.0) part.add(a);
    if ((at_a < 0.0 && at_b > 0.0) || (at_a > 0.0 && at_b < 0.0)) part.add(waterline_point(a, at_a, b, at_b));
    a = b;
    at_a = at_b;
  }
  return part;
}

/// Points with their weights.
struct Rule {
  Points points;
  Lanes weights;
};

/// The four points of Stroud's conical product rule on the triangle: positive weights, exact for polynomials of degree
/// 3. The weights sum to the area.
Rule rule_on(Vec3 a, Vec3 b, Vec3 c) {
  // Gauss-Jacobi for the weight 1 - u and Gauss-Legendre on [0, 1], two points each.
  static constexpr double kU0 = 0.15505102572168219, kU1 = 0.64494897427831781;
  static constexpr double kWeight0 = 0.31804138174397717, kWeight1 = 0.18195861825602283;
  static constexpr double kV0 = 0.21132486540518712, kV1 = 0.78867513459481288;
  const Vec3 ab = b - a, ac = c - a;
  const Vec3 e0 = (1.0 - kV0) * ab + kV0 * ac, e1 = (1.0 - kV1) * ab + kV1 * ac;
  const Lanes s(1.0 - kU0, 1.0 - kU0, 1.0 - kU1, 1.0 - kU1);
  const double area = 0.5 * norm(cross(ab, ac));
  return {{a.x + s * Lanes(e0.x, e1.x, e0.x, e1.x), a.y + s * Lanes(e0.y, e1.y, e0.y, e1.y),
           a.z + s * Lanes(e0.z, e1.z, e0.z, e1.z)},
          area * Lanes(kWeight0, kWeight0, kWeight1, kWeight1)};
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

  /// A flat convex face, corners counter-clockwise or clockwise, which lies within `around`.
  void add(std::span<const Vec3> corners, Vec3 normal, const Patch& around) {
    const Signs height = signs(corners, [&](Vec3 p) { return plane_.height(p); });
    if (!height.negative) return;
    shade_.face(corners, normal, around);
    if (shade_.closed()) return;
    if (corners.size() == 4) {
      add({{corners[0], corners[1], corners[2], corners[3]}, 4}, height.positive, normal);
    } else {
      for (std::size_t i = 2; i < corners.size(); ++i)
        add({{corners[0], corners[i - 1], corners[i]}, 3}, height.positive, normal);
    }
  }

  SurfaceDrag result;

 private:
  void add(const Piece& piece, bool partly_dry, Vec3 normal) {
    if (!partly_dry) {
      add_wet(piece, normal);
      return;
    }
    const Piece wet = where_negative(piece, [&](Vec3 p) { return plane_.height(p); });
    if (wet.n >= 3) add_wet(wet, normal);
  }

  void add_wet(const Piece& wet, Vec3 normal) {
    // Where the surface moves against its normal it is on the lee side: no form drag there.
    const auto against = [&](Vec3 p) { return -dot(normal, velocity_at(relative_, p)); };
    const Signs speed = signs({wet.corners.data(), wet.n}, against);
    if (speed.both()) {
      add_side(where_negative(wet, against), normal, true);
      add_side(where_negative(wet, [&](Vec3 p) { return -against(p); }), normal, false);
    } else {
      add_side(wet, normal, speed.negative);
    }
  }

  void add_side(const Piece& piece, Vec3 normal, bool leads) {
    if (!leads && skin_ == 0.0) return;
    for (std::size_t i = 2; i < piece.n; ++i) {
      const Rule rule = rule_on(piece.corners[0], piece.corners[i - 1], piece.corners[i]);
      add_drag(rule.points, rule.weights * shade_.open_share(rule.points), normal, leads);
    }
  }

  /// Adds the drag at four points; each sum takes the points in turn.
  void add_drag(const Points& p, const Lanes& share, Vec3 normal, bool leads) {
    const Vec3 v = relative_.linear, w = relative_.angular;
    const Lanes vx = v.x + (w.y * p.z - w.z * p.y);
    const Lanes vy = v.y + (w.z * p.x - w.x * p.z);
    const Lanes vz = v.z + (w.x * p.y - w.y * p.x);
    const Lanes outwards = vx * normal.x + vy * normal.y + vz * normal.z;
    if (leads) {
      const Lanes coefficient = share * form_ * outwards.max(0.0);
      for (int k = 0; k < 4; ++k) result.form.add(coefficient[k], {p.x[k], p.y[k], p.z[k]});
    }
    const Lanes ax = vx - outwards * normal.x, ay = vy - outwards * normal.y, az = vz - outwards * normal.z;
    const Lanes factor = -share * skin_ * (ax * ax + ay * ay + az * az).sqrt();
    const Lanes fx = factor * ax, fy = factor * ay, fz = factor * az;
    const Lanes mx = p.y * fz - p.z * fy, my = p.z * fx - p.x * fz, mz = p.x * fy - p.y * fx;
    for (int k = 0; k < 4; ++k) result.skin_friction += {{fx[k], fy[k], fz[k]}, {mx[k], my[k], mz[k]}};
  }

  const Waterplane& plane_;
  const Twist& relative_;
  double form_;
  double skin_;
  Shade& shade_;
};

/// The box around points at one height.
Patch plan_patch(std::span<const Vec3> points) {
  Vec3 low = points.front(), high = low;
  for (const Vec3 p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), low.z};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), high.z};
  }
  return {0.5 * (low + high), {0.5 * (high.x - low.x), 0.0, 0.0}, {0.0, 0.5 * (high.y - low.y), 0.0}};
}

}  // namespace

SurfaceDrag surface_drag(const Prism& prism, const Waterplane& plane, const Twist& relative, const Water& water,
                         Shade shade) {
  Integral integral(plane, relative, water, shade);
  const double half = 0.5 * prism.thickness;
  std::vector<Vec3> corners;
  for (const double side : {-1.0, 1.0}) {
    for (const auto& part : prism.parts) {
      corners.clear();
      for (const Vec2 vertex : part) corners.push_back({vertex.x, vertex.y, side * half});
      integral.add(corners, {0.0, 0.0, side}, plan_patch(corners));
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
      const Vec2 middle = 0.5 * (from + to), u = 0.5 * (to - from);
      integral.add(face, {out.x, out.y, 0.0}, {{middle.x, middle.y, 0.0}, {u.x, u.y, 0.0}, {0.0, 0.0, half}});
    }
  }
  return integral.result;
}

}  // namespace brash::hydrodynamics
