// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "brash/core/contract.hpp"
#include "brash/geometry/polygon.hpp"

namespace brash::geometry {
namespace {

/// A side of the part, moved in: the points x with normal . x >= offset are kept.
struct HalfPlane {
  Vec2 normal;
  double offset;

  double height(Vec2 point) const { return dot(normal, point) - offset; }
};

/// Metres from `origin`, so that a small part far out loses no digits. Straight-on vertices change nothing.
std::vector<Vec2> vertices_from(std::span<const Point> part, Point origin) {
  std::vector<Vec2> vertices;
  vertices.reserve(part.size());
  for (const Point p : part) vertices.push_back(metres(p - origin));
  return vertices;
}

/// The part of `ring` above the line; convex as `ring` was.
std::vector<Vec2> clipped(const std::vector<Vec2>& ring, const HalfPlane& line) {
  std::vector<Vec2> kept;
  kept.reserve(ring.size() + 1);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    const double height_a = line.height(a), height_b = line.height(b);
    if (height_a >= 0.0) kept.push_back(a);
    if ((height_a < 0.0) != (height_b < 0.0)) kept.push_back(a + height_a / (height_a - height_b) * (b - a));
  }
  return kept;
}

/// Drops vertices closer than `length` to the one kept before and vertices that turn right or go straight on.
std::vector<Vec2> tidied(std::vector<Vec2> ring, double length) {
  bool has_changed = true;
  while (has_changed && ring.size() >= 3) {
    has_changed = false;
    for (std::size_t i = 0; i < ring.size() && ring.size() >= 3; ++i) {
      const std::size_t n = ring.size();
      const Vec2 in = ring[i] - ring[(i + n - 1) % n], out = ring[(i + 1) % n] - ring[i];
      if (norm(in) >= length && cross(in, out) > 0.0) continue;
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
      has_changed = true;
      --i;
    }
  }
  return ring.size() >= 3 ? ring : std::vector<Vec2>{};
}

}  // namespace

std::vector<Vec2> inset(std::span<const Point> part, double distance) {
  BRASH_EXPECTS(distance >= 0.0, distance);
  BRASH_EXPECTS(is_convex(part), part.size());
  const Point origin = part.front();
  const std::vector<Vec2> vertices = vertices_from(part, origin);

  std::vector<Vec2> ring = vertices;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec2 along = vertices[(i + 1) % vertices.size()] - vertices[i];
    if (norm(along) == 0.0) continue;
    const Vec2 normal = perpendicular(normalized(along));
    ring = clipped(ring, {normal, dot(normal, vertices[i]) + distance});
    if (ring.size() < 3) return {};
  }
  ring = tidied(std::move(ring), kGridUnit);
  for (Vec2& vertex : ring) vertex += metres(origin);
  return ring;
}

}  // namespace brash::geometry
