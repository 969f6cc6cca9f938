// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_drag.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory_resource>
#include <vector>

#include "lanes.hpp"
#include "wetted_faces.hpp"

namespace brash::hydrodynamics {
namespace {

/// A flat face lies among the points centre + s u + t v with s and t from -1 to 1; body frame.
struct Face {
  Vec3 centre{};
  Vec3 u{};
  Vec3 v{};             ///< at right angles to u
  Vec3 normal{};        ///< unit, outward
  bool narrow = false;  ///< on a trapezoid of it four points are enough; on others two triangles have eight
};

/// A linear function of the place (s, t) on a face.
struct Linear {
  double middle;
  double s;
  double t;

  double reach() const { return std::abs(s) + std::abs(t); }
  double operator()(Vec2 p) const { return middle + s * p.x + t * p.y; }
  Linear operator-() const { return {-middle, -s, -t}; }
};

using Polygon = std::pmr::vector<Vec2>;

/// The part of a convex polygon where `value` is negative.
void where_negative(std::span<const Vec2> polygon, const Linear& value, Polygon& part) {
  part.clear();
  Vec2 a = polygon.back();
  double at_a = value(a);
  for (const Vec2 b : polygon) {
    const double at_b = value(b);
    if ((at_a < 0.0 && at_b > 0.0) || (at_a > 0.0 && at_b < 0.0)) part.push_back(a + at_a / (at_a - at_b) * (b - a));
    if (at_b <= 0.0) part.push_back(b);
    a = b;
    at_a = at_b;
  }
}

/// Gauss's rule of two points for the mean of f(x) from -1 to 1 with the weight 1 + k x; k from -1 to 1
/// (docs/theory/water.md, (H11)).
struct LinearGauss {
  explicit LinearGauss(double k) {
    // The points are the zeros of x^2 + b x + c, whose products with 1 and x have the mean 0.
    const double b = -0.8 * k / (3.0 - k * k), c = -(1.0 + b * k) / 3.0;
    const double half = std::sqrt(0.25 * b * b - c);
    x0 = -0.5 * b - half;
    x1 = -0.5 * b + half;
    weight0 = (x1 - k / 3.0) / (2.0 * half);
  }
  double x0, x1, weight0;
};

/// Four points of the surface in its integrals.
struct Sample {
  Vectors points;
  Lanes area;
  Vec3 normal;
};

/// The points at which the integrals over the wetted surface take their integrands: on a piece of the surface where
/// these are polynomials of degree 3 the integrals are exact.
class Samples {
 public:
  Samples(const Waterplane& plane, const Twist& relative) : plane_(plane), relative_(relative) {
    list_.reserve(48);
    wet_.reserve(16);
    side_.reserve(16);
    half_.reserve(16);
  }

  /// Adds the wetted part of a face.
  /// @param corners  (s, t) of the convex face.
  void add(const Face& face, std::span<const Vec2> corners) {
    const Linear height{plane_.height(face.centre), dot(plane_.up, face.u), dot(plane_.up, face.v)};
    if (height.middle >= height.reach()) return;
    if (height.middle > -height.reach()) {
      where_negative(corners, height, wet_);
      corners = wet_;
      if (corners.size() < 3) return;
    }
    // Where the surface moves against its normal it is on the lee side, and the form drag ends at the border.
    const Vec3 n = face.normal;
    const Linear outwards{dot(n, velocity_at(relative_, face.centre)), dot(n, cross(relative_.angular, face.u)),
                          dot(n, cross(relative_.angular, face.v))};
    if (outwards.middle >= outwards.reach()) {
      add_leading(face, corners);
    } else if (outwards.middle <= -outwards.reach()) {
      add_piece(face, corners);
    } else {
      where_negative(corners, -outwards, side_);
      add_leading(face, side_);
      where_negative(corners, outwards, side_);
      add_piece(face, side_);
    }
  }

  const std::pmr::vector<Sample>& list() const { return list_; }

 private:
  void add_leading(const Face& face, std::span<const Vec2> corners) {
    if (!face.narrow || corners.size() < 3) return add_piece(face, corners);
    for (const double side : {-1.0, 1.0}) {
      where_negative(corners, {0.0, 0.0, side}, half_);
      add_piece(face, half_);
    }
  }

  void add_piece(const Face& face, std::span<const Vec2> corners) {
    if (corners.size() < 3) return;
    const Vec2 a = corners[0];
    if (face.narrow && corners.size() == 4) {
      const Vec2 b = corners[1], c = corners[2], d = corners[3];
      if ((a.x == b.x && c.x == d.x) || (a.y == b.y && c.y == d.y)) return add_parallel(face, a, b, c, d);
      if ((b.x == c.x && d.x == a.x) || (b.y == c.y && d.y == a.y)) return add_parallel(face, b, c, d, a);
    }
    static const LinearGauss kTriangle(-1.0);
    for (std::size_t i = 2; i < corners.size(); ++i) add_trapezoid(face, corners[i - 1], corners[i], a, a, kTriangle);
  }

  /// A trapezoid whose sides ab and dc are parallel to an axis.
  void add_parallel(const Face& face, Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const double ab = std::abs(b.x - a.x + b.y - a.y), dc = std::abs(c.x - d.x + c.y - d.y);
    if (ab + dc > 0.0) add_trapezoid(face, a, b, c, d, LinearGauss((dc - ab) / (dc + ab)));
  }

  /// The product of Gauss rules on a trapezoid whose sides ab and dc are parallel.
  /// @param across  with k = (|dc| - |ab|) / (|dc| + |ab|).
  void add_trapezoid(const Face& face, Vec2 a, Vec2 b, Vec2 c, Vec2 d, const LinearGauss& across) {
    constexpr double k0 = 0.21132486540518712, k1 = 0.78867513459481288;  // Gauss-Legendre on [0, 1]
    const double x0 = 0.5 + 0.5 * across.x0, x1 = 0.5 + 0.5 * across.x1;
    const Vec2 p0 = a + x0 * (d - a), q0 = b + x0 * (c - b) - p0, p1 = a + x1 * (d - a), q1 = b + x1 * (c - b) - p1;
    const double half_area = 0.25 * std::abs(cross(c - a, d - b)) * norm(cross(face.u, face.v));
    const double w0 = half_area * across.weight0, w1 = half_area - w0;
    const Lanes s(p0.x + k0 * q0.x, p0.x + k1 * q0.x, p1.x + k0 * q1.x, p1.x + k1 * q1.x);
    const Lanes t(p0.y + k0 * q0.y, p0.y + k1 * q0.y, p1.y + k0 * q1.y, p1.y + k1 * q1.y);
    list_.push_back({{face.centre.x + s * face.u.x + t * face.v.x, face.centre.y + s * face.u.y + t * face.v.y,
                      face.centre.z + s * face.u.z + t * face.v.z},
                     {w0, w0, w1, w1},
                     face.normal});
  }

  const Waterplane& plane_;
  const Twist& relative_;
  std::array<std::byte, 12288> room_;  ///< enough for most floes; the rest is from the heap
  std::pmr::monotonic_buffer_resource memory_{room_.data(), room_.size()};
  std::pmr::vector<Sample> list_{&memory_};
  Polygon wet_{&memory_}, side_{&memory_}, half_{&memory_};
};

/// Top and bottom by the convex parts of the plan, and the sides.
void add_faces(const Prism& prism, Samples& samples) {
  const double half = 0.5 * prism.thickness;
  Polygon corners;
  corners.reserve(16);
  for (const auto& part : prism.parts) {
    Vec2 low = part.front(), high = low;
    for (const Vec2 p : part) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const Vec2 centre = 0.5 * (low + high), size = 0.5 * (high - low);
    if (size.x == 0.0 || size.y == 0.0) continue;
    corners.clear();
    for (const Vec2 p : part) corners.push_back({(p.x - centre.x) / size.x, (p.y - centre.y) / size.y});
    for (const double side : {-1.0, 1.0})
      samples.add({{centre.x, centre.y, side * half}, {size.x, 0.0, 0.0}, {0.0, size.y, 0.0}, {0.0, 0.0, side}},
                  corners);
  }
  static constexpr std::array<Vec2, 4> kWhole{Vec2{-1.0, -1.0}, Vec2{1.0, -1.0}, Vec2{1.0, 1.0}, Vec2{-1.0, 1.0}};
  for (const auto& ring : prism.rings) {
    Vec2 from = ring.back();
    for (const Vec2 to : ring) {
      const Vec2 middle = 0.5 * (from + to), u = 0.5 * (to - from);
      from = to;
      const double length = std::sqrt(dot(u, u));
      if (length == 0.0) continue;
      const Vec3 out{u.y / length, -u.x / length, 0.0};
      samples.add({{middle.x, middle.y, 0.0}, {u.x, u.y, 0.0}, {0.0, 0.0, half}, out, true}, kWhole);
    }
  }
}

/// Sums (H5) over samples of the surface.
class Integral {
 public:
  Integral(const Twist& relative, const Water& water)
      : relative_(relative),
        along_normal_(water.form_drag_along == FormDragAlong::kNormal),
        form_(0.5 * water.density * water.form_drag),
        skin_(0.5 * water.density * water.skin_friction) {}

  void add(const Sample& sample, Lanes open) {
    const Vectors& p = sample.points;
    const Vec3 n = sample.normal;
    const Vectors velocity = cross(relative_.angular, p) + relative_.linear;
    const Lanes area = sample.area * open;
    const Lanes outwards = dot(velocity, n);

    const Lanes damper = form_ * area * max(outwards, 0.0);
    if (along_normal_)
      add_along(n, damper, p);
    else
      add_in_points(damper, p);

    const Vectors along{velocity.x - outwards * n.x, velocity.y - outwards * n.y, velocity.z - outwards * n.z};
    const Lanes speed = sqrt(along.x * along.x + along.y * along.y + along.z * along.z);
    const Vectors f = -skin_ * area * speed * along;
    force_ += f;
    moment_ += {p.y * f.z - p.z * f.y, p.z * f.x - p.x * f.z, p.x * f.y - p.y * f.x};
  }

  Drag result() const {
    return {{.sum = sum(dampers_),
             .first = sum(first_),
             .squares = sum(squares_),
             .products = sum(products_),
             .normal = normal_},
            {sum(force_), sum(moment_)}};
  }

 private:
  void add_in_points(Lanes damper, const Vectors& p) {
    const Vectors moment = damper * p;
    dampers_ += damper;
    first_ += moment;
    squares_ += {moment.x * p.x, moment.y * p.y, moment.z * p.z};
    products_ += {moment.y * p.z, moment.z * p.x, moment.x * p.y};
  }

  /// (H15).
  void add_along(Vec3 n, Lanes damper, const Vectors& p) {
    const double c = sum(damper);
    if (c == 0.0) return;
    const Vectors arm = cross(-n, p);  // p x n
    const Vectors weighted = damper * arm;
    const Vec3 moment = sum(weighted);
    normal_.squares += c * Vec3{n.x * n.x, n.y * n.y, n.z * n.z};
    normal_.products += c * Vec3{n.y * n.z, n.z * n.x, n.x * n.y};
    normal_.with_x += n.x * moment;
    normal_.with_y += n.y * moment;
    normal_.with_z += n.z * moment;
    normal_.turning_squares += {sum(weighted.x * arm.x), sum(weighted.y * arm.y), sum(weighted.z * arm.z)};
    normal_.turning_products += {sum(weighted.y * arm.z), sum(weighted.z * arm.x), sum(weighted.x * arm.y)};
  }

  const Twist& relative_;
  bool along_normal_;
  double form_;
  double skin_;
  Lanes dampers_;
  Vectors first_, squares_, products_;
  NormalDamping normal_{};
  Vectors force_, moment_;  ///< of the skin friction
};

/// Sends for the planes: among many floes they are far from the processor, and are here when the samples are made.
void fetch(std::span<const Solid> neighbours) {
  constexpr std::size_t kLine = 64 / sizeof(Plane), kMost = 8;
  for (const Solid solid : neighbours)
    for (std::size_t i = 0; i < std::min(solid.size(), kMost); i += kLine) __builtin_prefetch(&solid[i]);
}

}  // namespace

Drag surface_drag(const Prism& prism, const Pose& pose, const Twist& relative, const Water& water,
                  std::span<const Solid> neighbours) {
  fetch(neighbours);
  const Waterplane plane = waterplane_in_body_frame(pose);
  Samples samples(plane, relative);
  add_faces(prism, samples);
  const auto& list = samples.list();
  if (list.empty()) return {};

  std::array<std::byte, 8192> room;
  std::pmr::monotonic_buffer_resource memory(room.data(), room.size());
  std::pmr::vector<Lanes> open(list.size(), 1.0, &memory);
  if (water.shading_gap > 0.0) {
    std::pmr::vector<Vectors> probes(&memory);
    probes.reserve(list.size());
    for (const Sample& sample : list) probes.push_back(sample.points + water.shading_gap * sample.normal);
    open_shares(probes, pose, neighbours, water.shading_gap, open);
  }
  Integral integral(relative, water);
  for (std::size_t i = 0; i < list.size(); ++i) integral.add(list[i], open[i]);
  return integral.result();
}

}  // namespace brash::hydrodynamics
