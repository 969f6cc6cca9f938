// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/edge/splitting_force.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "brash/floes/plan.hpp"

namespace brash::edge {

std::optional<SplittingForce> splitting_force(std::span<const EdgeContact> contacts, int level_ice) {
  Vec2 whole{};
  const EdgeContact* strongest = nullptr;
  const auto in_plane = [](const EdgeContact& contact) { return norm(plan(contact.on_ice)); };
  for (const EdgeContact& contact : contacts) {
    if (contact.level_ice != level_ice || !(contact.bound > 0.0)) continue;
    whole += plan(contact.on_ice);
    if (strongest == nullptr || in_plane(contact) > in_plane(*strongest)) strongest = &contact;
  }
  const double push = norm(whole);
  if (strongest == nullptr || !(push > 0.0)) return std::nullopt;
  const Vec2 towards = whole / push;
  double left = 0.0, right = 0.0;
  for (const EdgeContact& contact : contacts) {
    if (contact.level_ice != level_ice) continue;
    const double across = cross(towards, plan(contact.on_ice));
    left += contact.spread + std::max(0.0, across);
    right += contact.spread + std::max(0.0, -across);
  }
  return SplittingForce{strongest->region.midpoint, towards, push, std::min(left, right)};
}

std::optional<failure::SplitPlate> rectangle_ahead(const geometry::IceSheet& sheet, const SplittingForce& force) {
  double length = 0.0, left = 0.0, right = 0.0;
  const auto widen = [&](double across) {
    left = std::max(left, across);
    right = std::max(right, -across);
  };
  // Where a coordinate that goes from `a` to `b` is zero, the other from `c` to `d` is this.
  const auto where_zero = [](double a, double b, double c, double d) { return c + a / (a - b) * (d - c); };
  for (const geometry::Polygon& polygon : sheet.polygons()) {
    const std::vector<Vec2> ring = floes::to_metres(polygon.outline);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 one = ring[i] - force.at, other = ring[(i + 1) % ring.size()] - force.at;
      const double x1 = dot(one, force.towards), y1 = cross(force.towards, one);
      const double x2 = dot(other, force.towards), y2 = cross(force.towards, other);
      if (x1 > 0.0) widen(y1);
      if ((x1 > 0.0) != (x2 > 0.0)) widen(where_zero(x1, x2, y1, y2));
      if ((y1 > 0.0) != (y2 > 0.0)) length = std::max(length, where_zero(y1, y2, x1, x2));
    }
  }
  const double side = std::min(left, right);
  if (!(length > 0.0) || !(side > 0.0)) return std::nullopt;
  return failure::SplitPlate{length, 2.0 * side};
}

}  // namespace brash::edge
