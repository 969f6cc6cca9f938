// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/geometry/polygon.hpp"

#include <algorithm>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "predicates.hpp"

namespace brash::geometry {
namespace {

/// First moments about `origin` [m3] and area [m2] of everything added so far.
struct Moments {
  Point origin;
  double area = 0.0;
  double x = 0.0;
  double y = 0.0;

  /// Adds the fan of triangles from `origin` over the ring; each triangle's area is exact before it is rounded.
  void add(std::span<const Point> ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[(i + 1) % ring.size()];
      const double triangle = ExactArea(turn(origin, a, b)).square_metres();
      const Vec2 from_a = metres(a - origin), from_b = metres(b - origin);
      area += triangle;
      x += triangle * (from_a.x + from_b.x) / 3.0;
      y += triangle * (from_a.y + from_b.y) / 3.0;
    }
  }
};

}  // namespace

void Extent::add(Vec2 p) {
  lower = {std::min(lower.x, p.x), std::min(lower.y, p.y)};
  upper = {std::max(upper.x, p.x), std::max(upper.y, p.y)};
}

void Extent::add(const Extent& other) {
  if (other.is_empty()) return;
  add(other.lower);
  add(other.upper);
}

Extent extent(const Polygon& polygon) {
  Extent extent;
  for (const Point point : polygon.outline) extent.add(metres(point));
  return extent;
}

ExactArea signed_area(std::span<const Point> ring) {
  Int128 twice = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) twice += turn(ring[0], ring[i], ring[i + 1]);
  return ExactArea(twice);
}

ExactArea area(const Polygon& polygon) {
  ExactArea sum = signed_area(polygon.outline);
  for (const Ring& hole : polygon.holes) sum += signed_area(hole);
  return sum;
}

Vec2 centroid(const Polygon& polygon) {
  BRASH_EXPECTS(area(polygon) > ExactArea{}, area(polygon).to_string());
  Moments moments{.origin = polygon.outline.front()};
  moments.add(polygon.outline);
  for (const Ring& hole : polygon.holes) moments.add(hole);
  const double exact_area = area(polygon).square_metres();
  return metres(moments.origin) + Vec2{moments.x / exact_area, moments.y / exact_area};
}

bool is_convex(std::span<const Point> ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (side(ring[i], ring[(i + 1) % n], ring[(i + 2) % n]) < 0) return false;
  }
  return n >= 3;
}

Ring disc(Vec2 centre, double radius, int sides, double phase) {
  BRASH_EXPECTS(radius > 0.0 && sides >= 3, radius, sides);
  std::vector<Vec2> vertices;
  vertices.reserve(static_cast<std::size_t>(sides));
  for (int i = 0; i < sides; ++i) {
    const double angle = phase + 2.0 * kPi * i / sides;
    vertices.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return ring(vertices);
}

Ring ring(std::span<const Vec2> vertices) {
  Ring result;
  result.reserve(vertices.size());
  for (const Vec2& vertex : vertices) {
    const Point point = snap(vertex);
    if (result.empty() || result.back() != point) result.push_back(point);
  }
  while (result.size() > 1 && result.back() == result.front()) result.pop_back();
  if (signed_area(result) < ExactArea{}) std::reverse(result.begin() + 1, result.end());
  return result;
}

}  // namespace brash::geometry
