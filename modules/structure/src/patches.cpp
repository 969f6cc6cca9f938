// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/structure/patches.hpp"

#include <cmath>

namespace brash::structure {
namespace {

/// A side whose normal is nearer to the horizontal than this counts as vertical.
constexpr double kVertical = 1e-9;

/// The plan of a side, counter-clockwise.
Outline plan_of(const SidePiece& side) {
  Outline outline;
  for (const Vec3 v : side.outline) outline.push_back(plan(v));
  if (side.normal.z < 0.0) return {outline.rbegin(), outline.rend()};
  return outline;
}

/// The part of a ring inside a convex outline (Sutherland and Hodgman, 1974). Parts that do not hang together are
/// joined by edges that enclose nothing.
Outline common(Outline ring, const Outline& convex) {
  for (std::size_t i = 0; i < convex.size() && !ring.empty(); ++i) {
    const Vec2 from = convex[i], along = convex[(i + 1) % convex.size()] - from;
    Outline kept;
    for (std::size_t j = 0; j < ring.size(); ++j) {
      const Vec2 a = ring[j], b = ring[(j + 1) % ring.size()];
      const double at_a = cross(along, a - from), at_b = cross(along, b - from);
      if (at_a >= 0.0) kept.push_back(a);
      if ((at_a > 0.0 && at_b < 0.0) || (at_a < 0.0 && at_b > 0.0)) kept.push_back(a + at_a / (at_a - at_b) * (b - a));
    }
    ring = std::move(kept);
  }
  return ring;
}

/// Area and first moments about `origin`, signed by the ring's direction.
struct Moments {
  double area = 0.0;
  Vec2 first{};
};

void add(const Outline& ring, Vec2 origin, Moments& sum) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i] - origin, b = ring[(i + 1) % ring.size()] - origin;
    const double twice = cross(a, b);
    sum.area += 0.5 * twice;
    sum.first += twice / 6.0 * (a + b);
  }
}

}  // namespace

std::vector<Patch> patches_within(std::span<const SidePiece> sides, std::span<const std::vector<Vec2>> region) {
  std::vector<Patch> patches;
  for (const SidePiece& side : sides) {
    if (std::abs(side.normal.z) < kVertical) continue;
    const Outline outline = plan_of(side);
    const Vec2 origin = outline.front();
    Moments sum;
    for (const Outline& ring : region) add(common(ring, outline), origin, sum);
    if (!(sum.area > 0.0)) continue;
    const Vec2 middle = origin + sum.first / sum.area;
    const Vec3 on_side = side.outline.front();
    const double height = on_side.z - dot(plan(side.normal), middle - plan(on_side)) / side.normal.z;
    patches.push_back({side.normal, sum.area, sum.area / std::abs(side.normal.z), {middle.x, middle.y, height}});
  }
  return patches;
}

}  // namespace brash::structure
