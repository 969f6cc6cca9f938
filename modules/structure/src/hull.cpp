// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/structure/hull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "cone.hpp"

namespace brash::structure {
namespace {

std::unique_ptr<const Hull> hull_of(const model::Cone& cone) { return std::make_unique<Cone>(cone); }

/// A plane side: the line `towards . p = distance + widening z` of the plan at every height z.
struct PlaneSide {
  Vec2 towards{};         ///< unit, out of the hull
  double distance = 0.0;  ///< of the waterline from the origin [m]
  double widening = 0.0;  ///< cot of the slope, positive where the side leans outwards [-]
};

/// The section at height z between sides that follow each other counter-clockwise.
std::vector<Vec3> section(const std::vector<PlaneSide>& sides, double z) {
  std::vector<Vec3> ring;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const PlaneSide &a = sides[i], &b = sides[(i + 1) % sides.size()];
    const double at_a = a.distance + a.widening * z, at_b = b.distance + b.widening * z;
    const double turn = cross(a.towards, b.towards);
    ring.push_back(
        {(at_a * b.towards.y - at_b * a.towards.y) / turn, (at_b * a.towards.x - at_a * b.towards.x) / turn, z});
  }
  return ring;
}

/// @param shape  any with plane sides.
std::unique_ptr<const Hull> between_keel_and_top(const auto& shape, const std::vector<PlaneSide>& sides) {
  const double keel = -shape.height_under_water;
  return std::make_unique<Frustum>(section(sides, keel), section(sides, keel + shape.height));
}

double widening(const auto& shape) {
  return (shape.breaking == model::Breaking::kDownward ? 1.0 : -1.0) / std::tan(shape.angle);
}

std::unique_ptr<const Hull> hull_of(const model::FacetedCone& cone) {
  std::vector<PlaneSide> sides;
  for (int i = 0; i < cone.sides; ++i) {
    const double angle = 2.0 * kPi * i / cone.sides;
    sides.push_back({{std::cos(angle), std::sin(angle)}, 0.5 * cone.waterline_width, widening(cone)});
  }
  return between_keel_and_top(cone, sides);
}

std::unique_ptr<const Hull> hull_of(const model::Plane& plane) {
  const double half = 0.5 * plane.waterline_width, end = 0.5 * plane.length;
  return between_keel_and_top(
      plane,
      {{{1.0, 0.0}, end, widening(plane)}, {{0.0, 1.0}, half, 0.0}, {{-1.0, 0.0}, end, 0.0}, {{0.0, -1.0}, half, 0.0}});
}

std::unique_ptr<const Hull> hull_of(const model::WedgeBow& bow) {
  const double half = 0.5 * bow.waterline_width, end = 0.5 * bow.length;
  const double along = std::sin(bow.entrance), across = std::cos(bow.entrance);
  return between_keel_and_top(bow, {{{along, -across}, end * along, widening(bow)},
                                    {{along, across}, end * along, widening(bow)},
                                    {{0.0, 1.0}, half, 0.0},
                                    {{-1.0, 0.0}, end, 0.0},
                                    {{0.0, -1.0}, half, 0.0}});
}

}  // namespace

std::unique_ptr<const Hull> make_hull(const model::Shape& shape) {
  return std::visit([](const auto& kind) { return hull_of(kind); }, shape);
}

std::pair<Vec3, Vec3> Hull::bounds() const {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Vec3 least{kFar, kFar, kFar}, most = -least;
  for (const ConvexPart& part : parts())
    for (const Vec3 v : part) {
      least = {std::min(least.x, v.x), std::min(least.y, v.y), std::min(least.z, v.z)};
      most = {std::max(most.x, v.x), std::max(most.y, v.y), std::max(most.z, v.z)};
    }
  return {least, most};
}

/// In the middle of the vertices that reach as far, so that a straight front is met in its middle.
Foremost foremost(const Hull& hull, const Pose& pose, double bottom, double top, Vec2 course) {
  constexpr double kAsFar = 1e-6;  // [m]
  const Vec2 ahead = normalized(course);
  std::vector<Vec2> vertices;
  for (const Outline& outline : hull.footprint(pose, bottom, top).leading)
    vertices.insert(vertices.end(), outline.begin(), outline.end());
  BRASH_EXPECTS(!vertices.empty(), bottom, top);
  double reach = dot(ahead, vertices.front());
  for (const Vec2 v : vertices) reach = std::max(reach, dot(ahead, v));
  std::erase_if(vertices, [&](Vec2 v) { return dot(ahead, v) < reach - kAsFar; });
  Vec2 sum{};
  for (const Vec2 v : vertices) sum += v;
  const Vec2 middle = sum / static_cast<double>(vertices.size());
  return {hull.surface_at(pose, {middle.x, middle.y, 0.0}), reach};
}

}  // namespace brash::structure
