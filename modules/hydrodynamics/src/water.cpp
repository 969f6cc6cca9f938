// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/hydrodynamics/water.hpp"

#include <algorithm>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "damping.hpp"
#include "surface_drag.hpp"
#include "wetted_faces.hpp"

namespace brash::hydrodynamics {
namespace {

/// What the wetted surface says about the floe, body frame.
struct WettedBody {
  double volume = 0.0;
  Vec3 volume_moment{};
};

/// Adds the cone from the reference point on the waterplane to a wetted face. The waterplane's own cap has no cone.
void add_cone(WettedBody& body, const WettedFace& face, Vec3 reference) {
  const double signed_volume = (dot(face.normal, face.area_moment) - face.area * dot(face.normal, reference)) / 3.0;
  body.volume += signed_volume;
  // The centroid of a cone lies a quarter of the way from the base's centroid to the apex.
  body.volume_moment += signed_volume * (0.75 / face.area * face.area_moment + 0.25 * reference);
}

WettedBody wetted_body(const Prism& prism, const Waterplane& water) {
  const Vec3 reference = -water.offset * water.up;
  WettedBody body;
  for_each_wetted_face(prism, water, [&](const WettedFace& face) { add_cone(body, face, reference); });
  return body;
}

/// Mean of length, breadth (extents along the principal axes of the plan) and thickness [m].
double average_length(const Prism& prism) {
  Vec2 low = prism.rings.front().front();
  Vec2 high = low;
  for (const Vec2 vertex : prism.rings.front()) {
    low = {std::min(low.x, vertex.x), std::min(low.y, vertex.y)};
    high = {std::max(high.x, vertex.x), std::max(high.y, vertex.y)};
  }
  return (high.x - low.x + high.y - low.y + prism.thickness) / 3.0;
}

/// Eqs. 13 and 14 at one velocity for the whole floe, as dampers at that velocity: only faces that look along it count.
/// Skin friction on each wetted face by the velocity along it at its centroid.
SurfaceDrag paper_law(const Prism& prism, const Waterplane& plane, Vec3 centre, const Twist& relative,
                      const Water& water) {
  SurfaceDrag drag;
  const Vec3 velocity = velocity_at(relative, centre);
  double area = 0.0;
  double area_times_speed = 0.0;
  for_each_wetted_face(prism, plane, [&](const WettedFace& face) {
    area += face.area;
    area_times_speed += face.area * std::max(0.0, dot(face.normal, velocity));
    const Vec3 centroid = face.area_moment / face.area;
    const Vec3 there = velocity_at(relative, centroid);
    const Vec3 along = there - dot(there, face.normal) * face.normal;
    const Vec3 force = -0.5 * water.density * water.skin_friction * face.area * norm(along) * along;
    drag.skin_friction += {force, cross(centroid, force)};
  });
  const double l_avg = average_length(prism);
  drag.form.add(0.5 * water.form_drag * water.density * area_times_speed, centre);
  drag.form.add_rotation(0.5 * water.rotational_drag * water.density * l_avg * l_avg * l_avg * area *
                         norm(relative.angular));
  return drag;
}

Wrench rotated(const Quaternion& q, const Wrench& w) { return {rotate(q, w.force), rotate(q, w.moment)}; }

void check(const Prism& prism) {
  BRASH_EXPECTS(!prism.rings.empty() && prism.rings.front().size() >= 3, prism.rings.size());
  BRASH_EXPECTS(prism.thickness > 0.0, prism.thickness);
}

}  // namespace

Displacement displacement(const Prism& prism, const Pose& pose) {
  check(prism);
  const Waterplane plane = waterplane_in_body_frame(pose);
  const WettedBody body = wetted_body(prism, plane);
  if (body.volume <= 0.0) return {};
  const Vec3 centre = body.volume_moment / body.volume;
  return {body.volume, to_world(pose, centre), centre};
}

WaterLoad water_load(const Prism& prism, const Pose& pose, const Twist& twist, const Water& water,
                     const StepInertia& step, std::span<const Solid> neighbours, const Displacement& wet) {
  check(prism);
  BRASH_EXPECTS(step.dt >= 0.0 && step.mass > 0.0, step.dt, step.mass);
  BRASH_EXPECTS(step.inertia.x > 0.0 && step.inertia.y > 0.0 && step.inertia.z > 0.0);
  if (wet.volume <= 0.0) return {};
  const Waterplane plane = waterplane_in_body_frame(pose);

  WaterLoad load;
  load.buoyancy.force = {0.0, 0.0, water.density * kGravity * wet.volume};
  load.buoyancy.moment = cross(rotate(pose.rotation, wet.centre_in_body), load.buoyancy.force);

  const Quaternion to_body_axes = conjugate(pose.rotation);
  const Twist relative{rotate(to_body_axes, twist.linear - water.current), rotate(to_body_axes, twist.angular)};
  const SurfaceDrag drag = water.drag_law == DragLaw::kSurface
                               ? surface_drag(prism, pose, relative, water, neighbours)
                               : paper_law(prism, plane, wet.centre_in_body, relative, water);
  load.skin_friction = rotated(pose.rotation, drag.skin_friction);

  // The coefficient of the start of the step times the velocity at its end, as loads and drag alone give it.
  Wrench others{{0.0, 0.0, -step.weight}, {}};
  others += load.buoyancy;
  others += load.skin_friction;
  const Twist after = drag.form.velocity_after(relative, rotated(to_body_axes, others), step);
  load.drag = rotated(pose.rotation, drag.form.load(after));
  return load;
}

}  // namespace brash::hydrodynamics
