// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/hydrodynamics/water.hpp"

#include <algorithm>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "surface_drag.hpp"
#include "wetted_faces.hpp"

namespace brash::hydrodynamics {
namespace {

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
Drag paper_law(const Prism& prism, const Waterplane& plane, Vec3 centre, const Twist& relative, const Water& water) {
  Drag drag;
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
  drag.form.rotation =
      0.5 * water.rotational_drag * water.density * l_avg * l_avg * l_avg * area * norm(relative.angular);
  return drag;
}

Wrench rotated(const Quaternion& q, const Wrench& w) { return {rotate(q, w.force), rotate(q, w.moment)}; }

}  // namespace

Twist against_water(const Pose& pose, const Twist& twist, const Water& water) {
  const Quaternion to_body_axes = conjugate(pose.rotation);
  return {rotate(to_body_axes, twist.linear - water.current), rotate(to_body_axes, twist.angular)};
}

Drag Drag::scaled(double ratio) const {
  if (ratio == 0.0) return {};
  return {form.scaled(ratio), skin_friction, skin_power / ratio};
}

Drag drag(const Prism& prism, const Pose& pose, const Twist& twist, const Water& water,
          std::span<const Solid> neighbours, const Displacement& wet) {
  expect_solid(prism);
  if (wet.volume <= 0.0) return {};
  const Twist relative = against_water(pose, twist, water);
  Drag drag = water.drag_law == DragLaw::kSurface
                  ? surface_drag(prism, pose, relative, water, neighbours)
                  : paper_law(prism, waterplane_in_body_frame(pose), wet.centre_in_body, relative, water);
  const double skin_power = power(drag.skin_friction, relative);
  if (skin_power < 0.0)
    drag.skin_power = skin_power;
  else
    drag.skin_friction = {};
  return drag;
}

WaterLoad water_load(const Pose& pose, const Twist& twist, const Water& water, const StepInertia& step,
                     const Displacement& wet, const Drag& drag, const Wrench& besides) {
  BRASH_EXPECTS(step.dt >= 0.0 && step.mass > 0.0, step.dt, step.mass);
  BRASH_EXPECTS(step.inertia.x > 0.0 && step.inertia.y > 0.0 && step.inertia.z > 0.0);
  if (wet.volume <= 0.0) return {};
  WaterLoad load;
  load.buoyancy.force = {0.0, 0.0, water.density * kGravity * wet.volume};
  load.buoyancy.moment = cross(rotate(pose.rotation, wet.centre_in_body), load.buoyancy.force);
  const Twist relative = against_water(pose, twist, water);
  const double skin_share = power(drag.skin_friction, relative) / drag.skin_power;
  load.skin_friction =
      rotated(pose.rotation, {skin_share * drag.skin_friction.force, skin_share * drag.skin_friction.moment});

  // The coefficient of the start of the step times the velocity at its end, as loads and drag alone give it.
  Wrench others{{0.0, 0.0, -step.weight}, {}};
  others += load.buoyancy;
  others += load.skin_friction;
  others += besides;
  const Twist after = drag.form.velocity_after(relative, rotated(conjugate(pose.rotation), others), step);
  load.drag = rotated(pose.rotation, drag.form.load(after));
  return load;
}

}  // namespace brash::hydrodynamics
