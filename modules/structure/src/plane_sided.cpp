// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <vector>

#include "brash/core/constants.hpp"
#include "frustum.hpp"

namespace brash::structure {
namespace {

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

}  // namespace

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

}  // namespace brash::structure
