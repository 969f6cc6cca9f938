// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/hydrodynamics/water.hpp"

#include <algorithm>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "wetted_faces.hpp"

namespace brash::hydrodynamics {
namespace {

/// What the wetted surface says about the floe, body frame.
struct WettedBody {
  double volume = 0.0;
  Vec3 volume_moment{};
  double area = 0.0;
};

/// Adds the cone from the reference point on the waterplane to a wetted face. The waterplane's own cap has no cone.
void add_cone(WettedBody& body, const WettedFace& face, Vec3 reference) {
  const double signed_volume = (dot(face.normal, face.area_moment) - face.area * dot(face.normal, reference)) / 3.0;
  body.volume += signed_volume;
  // The centroid of a cone lies a quarter of the way from the base's centroid to the apex.
  body.volume_moment += signed_volume * (0.75 / face.area * face.area_moment + 0.25 * reference);
  body.area += face.area;
}

WettedBody wetted_body(const WettedFaces& faces, const Waterplane& water) {
  const Vec3 reference = -water.offset * water.up;
  WettedBody body;
  for (std::size_t i = 0; i < faces.size(); ++i) add_cone(body, faces[i], reference);
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

/// Form drag, Eq. 13: only faces that look along the velocity count. Body frame; the force acts at `centre`.
Vec3 form_drag(const WettedFaces& faces, Vec3 centre, Vec3 velocity, const Water& water, const StepInertia& step) {
  const double speed = norm(velocity);
  if (speed == 0.0) return {};
  double area_times_speed = 0.0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    area_times_speed += faces[i].area * std::max(0.0, dot(faces[i].normal, velocity));
  }
  const double damping = 0.5 * water.form_drag * water.density * area_times_speed;
  // A push at the centre of buoyancy also turns the floe, which makes it yield more.
  const Vec3 lever = cross(centre, velocity / speed);
  const double mobility = 1.0 / step.mass + lever.x * lever.x / step.inertia.x + lever.y * lever.y / step.inertia.y +
                          lever.z * lever.z / step.inertia.z;
  return -damping / (1.0 + damping * step.dt * mobility) * velocity;
}

/// Rotational drag, Eq. 14, body frame.
Vec3 rotational_drag(const Prism& prism, double wetted_area, Vec3 spin, const Water& water, const StepInertia& step) {
  const double l_avg = average_length(prism);
  const double damping = 0.5 * water.rotational_drag * water.density * l_avg * l_avg * l_avg * wetted_area * norm(spin);
  const auto about = [&](double component, double inertia) {
    return -damping / (1.0 + damping * step.dt / inertia) * component;
  };
  return {about(spin.x, step.inertia.x), about(spin.y, step.inertia.y), about(spin.z, step.inertia.z)};
}

/// Skin friction on each wetted face by the velocity along it at its centroid; body frame, moment about the origin.
Wrench skin_friction(const WettedFaces& faces, const Twist& relative, const Water& water) {
  Wrench total;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const WettedFace& face = faces[i];
    const Vec3 centroid = face.area_moment / face.area;
    const Vec3 velocity = velocity_at(relative, centroid);
    const Vec3 along = velocity - dot(velocity, face.normal) * face.normal;
    const Vec3 force = -0.5 * water.density * water.skin_friction * face.area * norm(along) * along;
    total += {force, cross(centroid, force)};
  }
  return total;
}

void check(const Prism& prism) {
  BRASH_EXPECTS(!prism.rings.empty() && prism.rings.front().size() >= 3, prism.rings.size());
  BRASH_EXPECTS(prism.thickness > 0.0, prism.thickness);
}

}  // namespace

Displacement displacement(const Prism& prism, const Pose& pose) {
  check(prism);
  const Waterplane plane = waterplane_in_body_frame(pose);
  const WettedBody body = wetted_body(WettedFaces(prism, plane), plane);
  if (body.volume <= 0.0) return {};
  return {body.volume, to_world(pose, body.volume_moment / body.volume)};
}

WaterLoad water_load(const Prism& prism, const Pose& pose, const Twist& twist, const Water& water,
                     const StepInertia& step) {
  check(prism);
  BRASH_EXPECTS(step.dt >= 0.0 && step.mass > 0.0, step.dt, step.mass);
  BRASH_EXPECTS(step.inertia.x > 0.0 && step.inertia.y > 0.0 && step.inertia.z > 0.0);
  const Waterplane plane = waterplane_in_body_frame(pose);
  const WettedFaces faces(prism, plane);
  const WettedBody body = wetted_body(faces, plane);
  if (body.volume <= 0.0) return {};
  const Vec3 centre = body.volume_moment / body.volume;

  WaterLoad load;
  load.buoyancy.force = {0.0, 0.0, water.density * kGravity * body.volume};
  load.buoyancy.moment = cross(rotate(pose.rotation, centre), load.buoyancy.force);

  const Quaternion to_body_axes = conjugate(pose.rotation);
  const Twist relative{rotate(to_body_axes, twist.linear - Vec3{water.current.x, water.current.y, 0.0}),
                       rotate(to_body_axes, twist.angular)};
  const Vec3 drag = form_drag(faces, centre, velocity_at(relative, centre), water, step);
  const Vec3 braking = rotational_drag(prism, body.area, relative.angular, water, step);
  load.drag = {rotate(pose.rotation, drag), rotate(pose.rotation, cross(centre, drag) + braking)};

  const Wrench friction = skin_friction(faces, relative, water);
  load.skin_friction = {rotate(pose.rotation, friction.force), rotate(pose.rotation, friction.moment)};
  return load;
}

}  // namespace brash::hydrodynamics
