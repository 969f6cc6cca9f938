// SPDX-License-Identifier: GPL-3.0-or-later
#include "damping.hpp"

namespace brash::hydrodynamics {

Wrench Damping::load(const Twist& twist) const {
  const Vec3 w = twist.angular;
  // sum c x x (w x x) = sum c (|x|^2 w - x (x . w))
  const Vec3 turning{(squares_.y + squares_.z) * w.x - products_.z * w.y - products_.y * w.z,
                     (squares_.z + squares_.x) * w.y - products_.x * w.z - products_.z * w.x,
                     (squares_.x + squares_.y) * w.z - products_.y * w.x - products_.x * w.y};
  return {-(sum_ * twist.linear + cross(w, first_)), -(cross(first_, twist.linear) + turning + rotation_ * w)};
}

Twist Damping::velocity_after(const Twist& twist, const Wrench& load, const StepInertia& step) const {
  const double dt = step.dt;
  const Vec3 linear = step.mass * twist.linear + dt * load.force;
  const Vec3 l = twist.angular;
  const Vec3 i = step.inertia;
  const Vec3 angular = Vec3{i.x * l.x, i.y * l.y, i.z * l.z} + dt * load.moment;

  // (M + dt D) V' = (linear, angular), with m v + w x f = linear put into f x v + T w = angular.
  const double m = step.mass + dt * sum_;
  const Vec3 f = dt * first_;
  const double xx = i.x + dt * (squares_.y + squares_.z + rotation_) - (f.y * f.y + f.z * f.z) / m;
  const double yy = i.y + dt * (squares_.z + squares_.x + rotation_) - (f.z * f.z + f.x * f.x) / m;
  const double zz = i.z + dt * (squares_.x + squares_.y + rotation_) - (f.x * f.x + f.y * f.y) / m;
  const double yz = f.y * f.z / m - dt * products_.x;
  const double zx = f.z * f.x / m - dt * products_.y;
  const double xy = f.x * f.y / m - dt * products_.z;

  // By Cramer's rule; the rows are the columns too.
  const Vec3 a{xx, xy, zx}, b{xy, yy, yz}, c{zx, yz, zz};
  const Vec3 right = angular - cross(f, linear) / m;
  const Vec3 bc = cross(b, c);
  const Vec3 w = Vec3{dot(right, bc), dot(right, cross(c, a)), dot(right, cross(a, b))} / dot(a, bc);
  return {(linear - cross(w, f)) / m, w};
}

}  // namespace brash::hydrodynamics
