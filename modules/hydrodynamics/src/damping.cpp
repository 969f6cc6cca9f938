// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/hydrodynamics/damping.hpp"

namespace brash::hydrodynamics {

Damping Damping::scaled(double factor) const {
  return {factor * sum, factor * first, factor * squares, factor * products, factor * rotation};
}

Wrench Damping::load(const Twist& twist) const {
  const Vec3 w = twist.angular;
  // sum c x x (w x x) = sum c (|x|^2 w - x (x . w))
  const Vec3 turning{(squares.y + squares.z) * w.x - products.z * w.y - products.y * w.z,
                     (squares.z + squares.x) * w.y - products.x * w.z - products.z * w.x,
                     (squares.x + squares.y) * w.z - products.y * w.x - products.x * w.y};
  return {-(sum * twist.linear + cross(w, first)), -(cross(first, twist.linear) + turning + rotation * w)};
}

Twist Damping::velocity_after(const Twist& twist, const Wrench& load, const StepInertia& step) const {
  const double dt = step.dt;
  const Vec3 linear = step.mass * twist.linear + dt * load.force;
  const Vec3 l = twist.angular;
  const Vec3 i = step.inertia;
  const Vec3 angular = Vec3{i.x * l.x, i.y * l.y, i.z * l.z} + dt * load.moment;

  // (M + dt D) V' = (linear, angular), with m v + w x f = linear put into f x v + T w = angular.
  const double m = step.mass + dt * sum;
  const Vec3 f = dt * first;
  const double xx = i.x + dt * (squares.y + squares.z + rotation) - (f.y * f.y + f.z * f.z) / m;
  const double yy = i.y + dt * (squares.z + squares.x + rotation) - (f.z * f.z + f.x * f.x) / m;
  const double zz = i.z + dt * (squares.x + squares.y + rotation) - (f.x * f.x + f.y * f.y) / m;
  const double yz = f.y * f.z / m - dt * products.x;
  const double zx = f.z * f.x / m - dt * products.y;
  const double xy = f.x * f.y / m - dt * products.z;

  // By Cramer's rule; the rows are the columns too.
  const Vec3 a{xx, xy, zx}, b{xy, yy, yz}, c{zx, yz, zz};
  const Vec3 right = angular - cross(f, linear) / m;
  const Vec3 bc = cross(b, c);
  const Vec3 w = Vec3{dot(right, bc), dot(right, cross(c, a)), dot(right, cross(a, b))} / dot(a, bc);
  return {(linear - cross(w, f)) / m, w};
}

}  // namespace brash::hydrodynamics
