// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "brash/hydrodynamics/water.hpp"
#include "wetted_faces.hpp"

namespace brash::hydrodynamics {
namespace {

/// The wetted body, body frame.
struct WettedBody {
  double volume = 0.0;
  Vec3 volume_moment{};
};

/// Integrals over the plan of 1; x, y; xx, xy, yy, by its rings.
struct PlanMoments {
  explicit PlanMoments(const Prism& prism) {
    for (const auto& ring : prism.rings) {
      if (ring.empty()) continue;
      Vec2 a = ring.back();
      for (const Vec2 b : ring) {
        // Over the triangle from the origin.
        const double twice = cross(a, b);
        const Vec2 s = a + b;
        area += 0.5 * twice;
        first += (twice / 6.0) * s;
        xx += (twice / 24.0) * (a.x * a.x + b.x * b.x + s.x * s.x);
        xy += (twice / 24.0) * (a.x * a.y + b.x * b.y + s.x * s.y);
        yy += (twice / 24.0) * (a.y * a.y + b.y * b.y + s.y * s.y);
        a = b;
      }
    }
  }

  double area = 0.0;
  Vec2 first{};
  double xx = 0.0, xy = 0.0, yy = 0.0;
};

/// Of a floe that the waterplane cuts in its sides alone, or not at all, (H12); nothing for others.
std::optional<WettedBody> cut_in_the_sides(const Prism& prism, const Waterplane& water) {
  const Vec2 slope = plan(water.up);
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const auto& ring : prism.rings)
    for (const Vec2 vertex : ring) {
      const double height = dot(slope, vertex);
      lowest = std::min(lowest, height);
      highest = std::max(highest, height);
    }
  const double steep = std::abs(water.up.z), half = 0.5 * prism.thickness;
  if (lowest + water.offset >= steep * half) return WettedBody{};
  const bool whole = highest + water.offset <= -steep * half;
  if (!whole && std::max(highest + water.offset, -(lowest + water.offset)) > steep * half) return std::nullopt;

  const PlanMoments moments(prism);
  if (whole) {
    const Vec2 first = prism.thickness * moments.first;
    return WettedBody{prism.thickness * moments.area, {first.x, first.y, 0.0}};
  }
  // Wetted on a length d = middle + along . (x, y) of the thickness, from the face that lies lower.
  const double middle = half - water.offset / steep;
  const Vec2 along = -1.0 / steep * slope;
  const double volume = middle * moments.area + dot(along, moments.first);
  const double x = middle * moments.first.x + along.x * moments.xx + along.y * moments.xy;
  const double y = middle * moments.first.y + along.x * moments.xy + along.y * moments.yy;
  const double squares = middle * volume + along.x * x + along.y * y;  // the integral of d^2
  const double z = 0.5 * squares - half * volume;
  return WettedBody{volume, {x, y, water.up.z > 0.0 ? z : -z}};
}

/// Adds the cone from the reference point on the waterplane to a wetted face. The waterplane's own cap has no cone.
void add_cone(WettedBody& body, const WettedFace& face, Vec3 reference) {
  const double signed_volume = (dot(face.normal, face.area_moment) - face.area * dot(face.normal, reference)) / 3.0;
  body.volume += signed_volume;
  // The centroid of a cone lies a quarter of the way from the base's centroid to the apex.
  body.volume_moment += signed_volume * (0.75 / face.area * face.area_moment + 0.25 * reference);
}

WettedBody by_cones(const Prism& prism, const Waterplane& water) {
  const Vec3 reference = -water.offset * water.up;
  WettedBody body;
  for_each_wetted_face(prism, water, [&](const WettedFace& face) { add_cone(body, face, reference); });
  return body;
}

}  // namespace

Displacement displacement(const Prism& prism, const Pose& pose) {
  expect_solid(prism);
  const Waterplane plane = waterplane_in_body_frame(pose);
  const std::optional<WettedBody> simple = cut_in_the_sides(prism, plane);
  const WettedBody body = simple ? *simple : by_cones(prism, plane);
  if (body.volume <= 0.0) return {};
  const Vec3 centre = body.volume_moment / body.volume;
  return {body.volume, to_world(pose, centre), centre};
}

}  // namespace brash::hydrodynamics
