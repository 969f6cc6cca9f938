// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "frustum.hpp"

namespace brash::structure {
namespace {

using model::Breaking;

double keel(const model::Cone& cone) { return -cone.height_under_water; }
double top(const model::Cone& cone) { return keel(cone) + cone.height; }

/// Radius of the section at height z [m].
double radius_at(const model::Cone& cone, double z) {
  const double widening = z / std::tan(cone.angle);
  return 0.5 * cone.waterline_width + (cone.breaking == Breaking::kDownward ? widening : -widening);
}

/// The section at height z, counter-clockwise, its vertices on the circle; hull's frame [m].
std::vector<Vec3> ring_at(const model::Cone& cone, double z) {
  const double radius = radius_at(cone, z);
  BRASH_EXPECTS(radius > 0.0 && cone.facets >= 3, radius, z, cone.facets);
  std::vector<Vec3> ring;
  ring.reserve(static_cast<std::size_t>(cone.facets));
  for (int i = 0; i < cone.facets; ++i) {
    const double angle = 2.0 * kPi * i / cone.facets;
    ring.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
  }
  return ring;
}

/// Whether the axis stands upright.
bool is_upright(const Pose& pose) { return pose.rotation.x == 0.0 && pose.rotation.y == 0.0; }

}  // namespace

Cone::Cone(const model::Cone& cone) : Frustum(ring_at(cone, keel(cone)), ring_at(cone, top(cone))), cone_(cone) {}

Footprint Cone::footprint(const Pose& pose, double bottom, double top_of_ice) const {
  const bool is_vertical = is_steep({std::sin(cone_.angle), 0.0, std::cos(cone_.angle)});
  if (is_vertical || !is_upright(pose)) return Frustum::footprint(pose, bottom, top_of_ice);
  const double lower = bottom - pose.position.z, upper = top_of_ice - pose.position.z;
  if (upper < keel(cone_) || lower > top(cone_)) return {};
  const auto outline_at = [&](double z) {
    Outline outline;
    for (const Vec3 v : ring_at(cone_, std::clamp(z, keel(cone_), top(cone_))))
      outline.push_back(plan(to_world(pose, v)));
    return outline;
  };
  // The wider end of the thickness leads.
  const bool downward = cone_.breaking == Breaking::kDownward;
  Footprint result{.leading = {outline_at(downward ? upper : lower)}, .trailing = {}};
  if (lower >= keel(cone_) && upper <= top(cone_)) result.trailing = {outline_at(downward ? lower : upper)};
  return result;
}

Surface Cone::surface_at(const Pose& pose, Vec3 point) const {
  const Vec2 arm = plan(to_body(pose, point));
  const Vec2 outwards = arm == Vec2{} ? Vec2{1.0, 0.0} : normalized(arm);
  const bool downward = cone_.breaking == Breaking::kDownward;
  const double along = std::sin(cone_.angle), up = downward ? -std::cos(cone_.angle) : std::cos(cone_.angle);
  const Vec3 normal = rotate(pose.rotation, {along * outwards.x, along * outwards.y, up});
  return is_upright(pose) ? Surface{normal, cone_.angle, cone_.breaking} : surface_with(normal);
}

Displacement Cone::displaced(const Pose& pose) const {
  const double draught = cone_.height_under_water - pose.position.z;
  if (!is_upright(pose) || draught <= 0.0 || draught >= cone_.height) return Frustum::displaced(pose);
  const double wide = radius_at(cone_, -pose.position.z), deep = radius_at(cone_, keel(cone_));
  const double squares = wide * wide + wide * deep + deep * deep;
  const double above_keel = 0.25 * draught * (deep * deep + 2.0 * wide * deep + 3.0 * wide * wide) / squares;
  return {kPi * draught / 3.0 * squares,
          {pose.position.x, pose.position.y, above_keel - draught},
          {.area = kPi * wide * wide, .radius = wide, .centre = plan(pose.position)}};
}

}  // namespace brash::structure
