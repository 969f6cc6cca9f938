// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/hydrodynamics/damping.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace brash::hydrodynamics {
namespace {

/// The product of a symmetric matrix, by its squares xx, yy, zz and products yz, zx, xy, with a vector.
Vec3 times(Vec3 squares, Vec3 products, Vec3 v) {
  return {squares.x * v.x + products.z * v.y + products.y * v.z, products.z * v.x + squares.y * v.y + products.x * v.z,
          products.y * v.x + products.x * v.y + squares.z * v.z};
}

using Column = std::array<double, 6>;
using Matrix = std::array<Column, 6>;

Column column(const Vec3& linear, const Vec3& angular) {
  return {linear.x, linear.y, linear.z, angular.x, angular.y, angular.z};
}

/// Solves a symmetric positive definite system by Cholesky's factors; reads the lower triangle.
Column solved(Matrix a, Column b) {
  for (std::size_t j = 0; j < 6; ++j) {
    for (std::size_t k = 0; k < j; ++k) a[j][j] -= a[j][k] * a[j][k];
    a[j][j] = std::sqrt(a[j][j]);
    for (std::size_t i = j + 1; i < 6; ++i) {
      for (std::size_t k = 0; k < j; ++k) a[i][j] -= a[i][k] * a[j][k];
      a[i][j] /= a[j][j];
    }
  }
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= a[i][k] * b[k];
    b[i] /= a[i][i];
  }
  for (std::size_t i = 6; i-- > 0;) {
    for (std::size_t k = i + 1; k < 6; ++k) b[i] -= a[k][i] * b[k];
    b[i] /= a[i][i];
  }
  return b;
}

}  // namespace

NormalDamping NormalDamping::scaled(double factor) const {
  return {factor * squares, factor * products,        factor * with_x,          factor * with_y,
          factor * with_z,  factor * turning_squares, factor * turning_products};
}

Wrench NormalDamping::load(const Twist& twist) const {
  const auto& [v, w] = twist;
  const Vec3 turned{dot(with_x, w), dot(with_y, w), dot(with_z, w)};
  return {-(times(squares, products, v) + turned),
          -(v.x * with_x + v.y * with_y + v.z * with_z + times(turning_squares, turning_products, w))};
}

Damping Damping::scaled(double factor) const {
  return {factor * sum, factor * first, factor * squares, factor * products, factor * rotation, normal.scaled(factor)};
}

Wrench Damping::load(const Twist& twist) const {
  const Vec3 w = twist.angular;
  // sum c x x (w x x) = sum c (|x|^2 w - x (x . w))
  const Vec3 turning{(squares.y + squares.z) * w.x - products.z * w.y - products.y * w.z,
                     (squares.z + squares.x) * w.y - products.x * w.z - products.z * w.x,
                     (squares.x + squares.y) * w.z - products.y * w.x - products.x * w.y};
  Wrench result{-(sum * twist.linear + cross(w, first)), -(cross(first, twist.linear) + turning + rotation * w)};
  if (normal != NormalDamping{}) result += normal.load(twist);
  return result;
}

Twist Damping::velocity_after(const Twist& twist, const Wrench& load, const StepInertia& step) const {
  if (step.added_across == 0.0 && normal == NormalDamping{}) return velocity_after_isotropic(twist, load, step);

  // (M + dt D) V' = M V + dt W; each column of D is the load against a unit velocity.
  const auto& [v, w] = twist;
  const double dt = step.dt;
  const Vec3 mass{step.mass, step.mass, step.mass + step.added_across}, i = step.inertia;
  const Column inertia = column(mass, i);
  Matrix matrix;
  for (std::size_t k = 0; k < 6; ++k) {
    Column unit{};
    unit[k] = 1.0;
    const Wrench against = this->load({{unit[0], unit[1], unit[2]}, {unit[3], unit[4], unit[5]}});
    matrix[k] = column(-dt * against.force, -dt * against.moment);
    matrix[k][k] += inertia[k];
  }
  const Column after = solved(matrix, column(Vec3{mass.x * v.x, mass.y * v.y, mass.z * v.z} + dt * load.force,
                                             Vec3{i.x * w.x, i.y * w.y, i.z * w.z} + dt * load.moment));
  return {{after[0], after[1], after[2]}, {after[3], after[4], after[5]}};
}

Twist Damping::velocity_after_isotropic(const Twist& twist, const Wrench& load, const StepInertia& step) const {
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
