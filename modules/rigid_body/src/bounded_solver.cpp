// SPDX-License-Identifier: GPL-3.0-or-later
#include "bounded_solver.hpp"

#include <algorithm>
#include <cmath>

#include "bullet_types.hpp"

namespace brash::rigid_body {
namespace {

/// Slower than this slip has no direction [m/s].
constexpr double kNoSlip = 0x1p-26;

Vec3 times(const std::array<Vec3, 3>& matrix, Vec3 v) {
  return {dot(matrix[0], v), dot(matrix[1], v), dot(matrix[2], v)};
}

/// Two directions normal to `normal` and to each other, the first that of `slip` [m/s] where there is any.
std::array<Vec3, 2> tangents(Vec3 normal, Vec3 slip) {
  const double speed = norm(slip);
  if (!(speed > kNoSlip)) {  // any two would do; these, and not plane_axes(), are those of the recorded results
    btVector3 first, second;
    btPlaneSpace1(to_bullet(normal), first, second);
    return {from_bullet(first), from_bullet(second)};
  }
  const Vec3 first = (1.0 / speed) * slip;
  const Vec3 second = cross(first, normal);
  return {first, (1.0 / norm(second)) * second};
}

}  // namespace

void BoundedSolver::clear() {
  bodies_.resize(1);
  contacts_.clear();
  bearings_.clear();
  normals_.clear();
  normal_responses_.clear();
  tangentials_.clear();
  partings_.clear();
}

std::uint32_t BoundedSolver::add(const SolverBody& body) {
  bodies_.push_back(body);
  return static_cast<std::uint32_t>(bodies_.size() - 1);
}

void BoundedSolver::add(const SolverContact& contact, std::span<const PatchPoint> points) {
  contacts_.push_back({.normal = contact.normal,
                       .friction = contact.friction,
                       .first = contact.first,
                       .second = contact.second,
                       .n_points = static_cast<std::uint32_t>(points.size())});
  for (const PatchPoint& point : points) {
    Bearing& bearing = bearings_.emplace_back();
    if (std::isfinite(contact.crushing_impulse)) bearing.bound = contact.crushing_impulse * point.area;
    add_point(contact, point.position);
  }
}

/// All of a row but its rhs. @return the relative velocity along it [m/s].
double BoundedSolver::set_up(const Arms& arms, Vec3 direction, Row& row, Response& response) {
  const auto& [first, second, first_arm, second_arm] = arms;
  const Vec3 turn_a = cross(first_arm, direction);
  const Vec3 turn_b = cross(second_arm, -direction);
  const Vec3 response_a = times(first.inverse_inertia, turn_a);
  const Vec3 response_b = times(second.inverse_inertia, turn_b);
  const double mobility_a = first.inverse_mass + dot(direction, cross(response_a, first_arm));
  const double mobility_b = second.inverse_mass + dot(direction, cross(-response_b, second_arm));
  row = {.turn_a = {turn_a.x, turn_a.y, turn_a.z},
         .turn_b = {turn_b.x, turn_b.y, turn_b.z},
         .inverse_jacobian = 1.0 / (mobility_a + mobility_b)};
  response = {{response_a.x, response_a.y, response_a.z}, {response_b.x, response_b.y, response_b.z}};
  return (dot(direction, first.twist.linear) + dot(turn_a, first.twist.angular)) +
         (dot(-direction, second.twist.linear) + dot(turn_b, second.twist.angular));
}

void BoundedSolver::add_point(const SolverContact& contact, Vec3 position) {
  const SolverBody& first = bodies_[contact.first];
  const SolverBody& second = bodies_[contact.second];
  const Arms arms{first, second, position - first.position, position - second.position};
  const Vec3 velocity = velocity_at(first.twist, arms.first_arm) - velocity_at(second.twist, arms.second_arm);
  const double approach = dot(contact.normal, velocity);

  Row& normal = normals_.emplace_back();
  Response& response = normal_responses_.emplace_back();
  const double speed = set_up(arms, contact.normal, normal, response);
  normal.rhs = (std::max(0.0, -contact.restitution * approach) - speed) * normal.inverse_jacobian;
  if (contact.parting_speed > 0.0) {
    Parting& parting = partings_.emplace_back(contact.normal, normal, response, 0.0, contact.first, contact.second);
    parting.row.rhs = contact.parting_speed * normal.inverse_jacobian;
  }

  const auto directions = tangents(contact.normal, velocity - approach * contact.normal);
  std::array<Tangential, 2>& rows = tangentials_.emplace_back();
  for (std::size_t i = 0; i < 2; ++i) {
    rows[i].direction = directions[i];
    const double slip = set_up(arms, directions[i], rows[i].row, rows[i].response);
    rows[i].row.rhs = -slip * rows[i].row.inverse_jacobian;
  }
}

/// Changes a row's impulse within its limits. @return the change of relative velocity [m/s].
double BoundedSolver::resolve(Moved& a, Moved& b, Vec3 direction, const Row& row, const Response& response,
                              Limits limits, double& impulse) {
  const auto relative = [](const Spatial& jacobian, const Spatial& velocity) {
    const Pair sum = jacobian[0] * velocity[0] + jacobian[1] * velocity[1] + jacobian[2] * velocity[2];
    return sum[0] + sum[1];
  };
  const Spatial jacobian_a{Pair{direction.x, row.turn_a[0]}, Pair{direction.y, row.turn_a[1]},
                           Pair{direction.z, row.turn_a[2]}};
  const Spatial jacobian_b{Pair{-direction.x, row.turn_b[0]}, Pair{-direction.y, row.turn_b[1]},
                           Pair{-direction.z, row.turn_b[2]}};
  double change = row.rhs;
  change -= relative(jacobian_a, a.velocity) * row.inverse_jacobian;
  change -= relative(jacobian_b, b.velocity) * row.inverse_jacobian;
  double wanted = impulse + change;
  if (wanted < limits.lower || wanted > limits.upper) {
    wanted = wanted < limits.lower ? limits.lower : limits.upper;
    change = wanted - impulse;
  }
  if (change == 0.0) return 0.0;
  impulse = wanted;
  const auto push = [&](Moved& body, const Spatial& jacobian, const Triple& turn) {
    for (std::size_t k = 0; k < 3; ++k) body.velocity[k] += Pair{jacobian[k][0] * body.inverse_mass, turn[k]} * change;
  };
  push(a, jacobian_a, response.turn_a);
  push(b, jacobian_b, response.turn_b);
  return std::abs(change / row.inverse_jacobian);
}

/// Eq. 6 for both tangential rows of a point, as a disc.
double BoundedSolver::resolve_friction(Moved& a, Moved& b, double friction, const std::array<Tangential, 2>& rows,
                                       Bearing& bearing) {
  auto& [first, second] = bearing.tangential;
  const double radius = friction * bearing.normal;
  if (radius == 0.0 && first == 0.0 && second == 0.0) return 0.0;
  const auto along = [&](const Tangential& t, double limit, double& impulse) {
    return resolve(a, b, t.direction, t.row, t.response, {-limit, limit}, impulse);
  };
  const double change = along(rows[0], radius, first);
  const double left = std::sqrt(std::max(0.0, (radius - first) * (radius + first)));
  return std::max(change, along(rows[1], left, second));
}

/// The sweeps return the largest change of a relative velocity [m/s].
double BoundedSolver::sweep_normals() {
  double largest = 0.0;
  std::size_t i = 0;
  for (const Contact& contact : contacts_)
    for (const std::size_t end = i + contact.n_points; i < end; ++i)
      largest = std::max(largest, resolve(moved_[contact.first], moved_[contact.second], contact.normal, normals_[i],
                                          normal_responses_[i], {0.0, bearings_[i].bound}, bearings_[i].normal));
  return largest;
}

double BoundedSolver::sweep_tangentials() {
  double largest = 0.0;
  std::size_t i = 0;
  for (const Contact& contact : contacts_)
    for (const std::size_t end = i + contact.n_points; i < end; ++i)
      largest = std::max(largest, resolve_friction(moved_[contact.first], moved_[contact.second], contact.friction,
                                                   tangentials_[i], bearings_[i]));
  return largest;
}

double BoundedSolver::sweep_partings() {
  constexpr Limits kPush{0.0, std::numeric_limits<double>::infinity()};
  double largest = 0.0;
  for (Parting& p : partings_)
    largest = std::max(largest,
                       resolve(parted_[p.first], parted_[p.second], p.direction, p.row, p.response, kPush, p.impulse));
  return largest;
}

double BoundedSolver::solve(int iterations, double still) {
  moved_.clear();
  for (const SolverBody& body : bodies_) moved_.push_back({.velocity = {}, .inverse_mass = body.inverse_mass});
  parted_ = moved_;
  for (int i = 0; i < iterations && !partings_.empty(); ++i)
    if (sweep_partings() <= still) break;
  double largest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < iterations && largest > still; ++i) {
    largest = sweep_normals();
    largest = std::max(largest, sweep_tangentials());
  }
  return largest;
}

Twist BoundedSolver::Moved::twist() const {
  const auto& [x, y, z] = velocity;
  return {{x[0], y[0], z[0]}, {x[1], y[1], z[1]}};
}

Twist BoundedSolver::twist(std::uint32_t body) const {
  const Twist before = bodies_[body].twist;
  const Twist change = moved_[body].twist();
  return {before.linear + change.linear, before.angular + change.angular};
}

Twist BoundedSolver::parting(std::uint32_t body) const { return parted_[body].twist(); }

PointImpulse BoundedSolver::impulse(std::size_t point) const {
  const Bearing& bearing = bearings_[point];
  const auto& rows = tangentials_[point];
  return {.normal = bearing.normal,
          .friction = bearing.tangential[0] * rows[0].direction + bearing.tangential[1] * rows[1].direction,
          .at_bound = bearing.normal >= bearing.bound};
}

}  // namespace brash::rigid_body
