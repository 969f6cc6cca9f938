// SPDX-License-Identifier: GPL-3.0-or-later
#include "damping.hpp"

#include <Eigen/Cholesky>

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
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  const Vec3 linear = step.mass * twist.linear + step.dt * load.force;
  const Vec3 l = twist.angular;
  const Vec3 i = step.inertia;
  const Vec3 angular = Vec3{i.x * l.x, i.y * l.y, i.z * l.z} + step.dt * load.moment;

  // M + dt D; only the lower triangle is read.
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
  matrix(0, 0) = matrix(1, 1) = matrix(2, 2) = step.mass + step.dt * sum_;
  const Vec3 f = step.dt * first_;
  matrix(4, 0) = f.z, matrix(5, 0) = -f.y;
  matrix(3, 1) = -f.z, matrix(5, 1) = f.x;
  matrix(3, 2) = f.y, matrix(4, 2) = -f.x;
  matrix(3, 3) = i.x + step.dt * (squares_.y + squares_.z + rotation_);
  matrix(4, 4) = i.y + step.dt * (squares_.z + squares_.x + rotation_);
  matrix(5, 5) = i.z + step.dt * (squares_.x + squares_.y + rotation_);
  matrix(4, 3) = -step.dt * products_.z;
  matrix(5, 3) = -step.dt * products_.y;
  matrix(5, 4) = -step.dt * products_.x;

  Vector6 momentum;
  momentum << linear.x, linear.y, linear.z, angular.x, angular.y, angular.z;
  const Vector6 v = matrix.llt().solve(momentum);
  return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
}

}  // namespace brash::hydrodynamics
