// SPDX-License-Identifier: GPL-3.0-or-later
#include "splitting_force.hpp"

#include <algorithm>
#include <cmath>

#include "plan.hpp"

namespace brash::simulation {

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
  for (const geometry::Polygon& polygon : sheet.polygons()) {
    for (const Vec2 vertex : to_metres(polygon.outline)) {
      const Vec2 arm = vertex - force.at;
      const double ahead = dot(arm, force.towards), across = cross(force.towards, arm);
      if (!(ahead > 0.0)) continue;
      length = std::max(length, ahead);
      left = std::max(left, across);
      right = std::max(right, -across);
    }
  }
  const double side = std::min(left, right);
  if (!(length > 0.0) || !(side > 0.0)) return std::nullopt;
  return failure::SplitPlate{length, 2.0 * side};
}

}  // namespace brash::simulation
