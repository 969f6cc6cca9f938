// SPDX-License-Identifier: GPL-3.0-or-later
#include "bounded_solver.hpp"

#include <algorithm>
#include <cmath>

#include "convex_part.hpp"

namespace brash::rigid_body {
namespace {

/// Of the sweeps of a step, as long as they change less and less: it lasts for a tenth of them
/// (docs/theory/dynamics.md, (C3)).
double most_momentum(int iterations) { return std::max(0.0, 1.0 - 10.0 / iterations); }

Vec3 times(const std::array<Vec3, 3>& matrix, Vec3 v) {
  return {dot(matrix[0], v), dot(matrix[1], v), dot(matrix[2], v)};
}

/// Velocity along `direction`, unit, per impulse along it [1/kg].
double mobility_along(const SolverBody& body, Vec3 direction) {
  if (body.stretch == 0.0) return body.inverse_mass;
  const Vec3 s = body.stretched(direction);
  return body.inverse_mass * dot(s, s);
}

/// Velocity along `one` per impulse along `other`, two directions at right angles [1/kg].
double mobility_across(const SolverBody& body, Vec3 one, Vec3 other) {
  if (body.stretch == 0.0) return 0.0;
  return body.inverse_mass * dot(body.stretched(one), body.stretched(other));
}

}  // namespace

void BoundedSolver::clear(double restitution) {
  restitution_ = restitution;
  bodies_.resize(1);
  contacts_.clear();
  normals_.clear();
  borne_.clear();
  bearings_.clear();
  positions_.clear();
  frictions_.clear();
  partings_.clear();
  joints_.clear();
}

std::uint32_t BoundedSolver::add(const SolverBody& body) {
  bodies_.push_back(body);
  return static_cast<std::uint32_t>(bodies_.size() - 1);
}

void BoundedSolver::add(const SolverContact& contact, std::span<const PatchPoint> points) {
  contacts_.push_back({.normal = contact.normal,
                       .direction_a = bodies_[contact.first].stretched(contact.normal),
                       .direction_b = bodies_[contact.second].stretched(-contact.normal),
                       .friction = contact.friction,
                       .first = contact.first,
                       .second = contact.second,
                       .n_points = static_cast<std::uint32_t>(points.size())});
  for (const PatchPoint& point : points) add_point(contact, point);
}

void BoundedSolver::add(const SolverJoint& joint) {
  const SolverBody &a = bodies_[joint.first], &b = bodies_[joint.second];
  const auto& [linear_a, angular_a] = joint.of_first;
  const auto& [linear_b, angular_b] = joint.of_second;
  const Vec3 turn_a = times(a.axes, angular_a), turn_b = times(b.axes, angular_b);
  const Vec3 direction_a = a.stretched(linear_a), direction_b = b.stretched(linear_b);
  const double mobility = a.inverse_mass * dot(direction_a, direction_a) + dot(turn_a, turn_a) +
                          b.inverse_mass * dot(direction_b, direction_b) + dot(turn_b, turn_b) + joint.softness;
  const double velocity = dot(linear_a, a.twist.linear) + dot(angular_a, a.twist.angular) +
                          dot(linear_b, b.twist.linear) + dot(angular_b, b.twist.angular);
  joints_.push_back({.direction_a = direction_a,
                     .direction_b = direction_b,
                     .row = {.turn_a = {turn_a.x, turn_a.y, turn_a.z},
                             .turn_b = {turn_b.x, turn_b.y, turn_b.z},
                             .velocity = velocity - joint.velocity,
                             .mass = mobility > 0.0 ? 1.0 / mobility : 0.0},
                     .softness = joint.softness,
                     .least = joint.least,
                     .most = joint.most,
                     .impulse = {},
                     .first = joint.first,
                     .second = joint.second});
}

BoundedSolver::Arms BoundedSolver::arms(std::uint32_t first, std::uint32_t second, Vec3 position) const {
  const SolverBody &a = bodies_[first], &b = bodies_[second];
  return {a, b, position - a.position, position - b.position};
}

/// The velocity comes from the bodies.
BoundedSolver::Row BoundedSolver::row(const Arms& arms, Vec3 direction) {
  const auto& [first, second, first_arm, second_arm] = arms;
  const Vec3 moment_a = cross(first_arm, direction);
  const Vec3 moment_b = cross(second_arm, -direction);
  const Vec3 turn_a = times(first.axes, moment_a);
  const Vec3 turn_b = times(second.axes, moment_b);
  const double mobility_a = mobility_along(first, direction) + dot(turn_a, turn_a);
  const double mobility_b = mobility_along(second, direction) + dot(turn_b, turn_b);
  return {.turn_a = {turn_a.x, turn_a.y, turn_a.z},
          .turn_b = {turn_b.x, turn_b.y, turn_b.z},
          .velocity = (dot(direction, first.twist.linear) + dot(moment_a, first.twist.angular)) +
                      (dot(-direction, second.twist.linear) + dot(moment_b, second.twist.angular)),
          .mass = 1.0 / (mobility_a + mobility_b)};
}

void BoundedSolver::add_point(const SolverContact& contact, const PatchPoint& point) {
  Row& normal = normals_.emplace_back(row(arms(contact.first, contact.second, point.position), contact.normal));
  Bearing& bearing = bearings_.emplace_back();
  borne_.push_back(0);
  positions_.push_back(point.position);
  if (std::isfinite(contact.crushing_impulse)) bearing.bound = contact.crushing_impulse * point.area;
  if (contact.parting_speed > 0.0) {
    partings_.push_back({bodies_[contact.first].stretched(contact.normal),
                         bodies_[contact.second].stretched(-contact.normal),
                         normal,
                         {},
                         contact.first,
                         contact.second});
    partings_.back().row.velocity = -contact.parting_speed;
  }
  normal.velocity *= 1.0 + restitution_;
}

/// @return its number.
std::uint32_t BoundedSolver::add_friction(const Contact& contact, Vec3 position) {
  Friction& friction = frictions_.emplace_back();
  friction.first = contact.first;
  friction.second = contact.second;
  friction.tangents = plane_axes(contact.normal);
  const Arms from_centres = arms(contact.first, contact.second, position);
  for (std::size_t k = 0; k < 2; ++k) {
    const Vec3 tangent = friction.tangents[k];
    friction.directions_a[k] = from_centres.first.stretched(tangent);
    friction.directions_b[k] = from_centres.second.stretched(-tangent);
    friction.rows[k] = row(from_centres, tangent);
    friction.rows[k].velocity *= 1.0 + restitution_;
  }
  auto& [first, second] = friction.rows;
  // Slip per impulse in the first direction, in the second, and in one per impulse in the other.
  const double give_first = 1.0 / first.mass, give_second = 1.0 / second.mass;
  double across = mobility_across(from_centres.first, friction.tangents[0], friction.tangents[1]) +
                  mobility_across(from_centres.second, friction.tangents[0], friction.tangents[1]);
  for (std::size_t i = 0; i < 3; ++i) across += first.turn_a[i] * second.turn_a[i] + first.turn_b[i] * second.turn_b[i];
  const double determinant = give_first * give_second - across * across;
  first.mass = give_second / determinant;
  second.mass = give_first / determinant;
  friction.coupling = -across / determinant;
  friction.least_mass = 2.0 / (give_first + give_second + std::hypot(give_first - give_second, 2.0 * across));
  return static_cast<std::uint32_t>(frictions_.size() - 1);
}

BoundedSolver::Jacobian::Jacobian(Vec3 direction_a, Vec3 direction_b, const Row& row)
    : a{Pair{direction_a.x, row.turn_a[0]}, Pair{direction_a.y, row.turn_a[1]}, Pair{direction_a.z, row.turn_a[2]}},
      b{Pair{direction_b.x, row.turn_b[0]}, Pair{direction_b.y, row.turn_b[1]}, Pair{direction_b.z, row.turn_b[2]}} {}

double BoundedSolver::Jacobian::velocity(const Moved& first, const Moved& second) const {
  const Spatial &u = first.velocity, &v = second.velocity;
  const Pair sum = (a[0] * u[0] + a[1] * u[1] + a[2] * u[2]) + (b[0] * v[0] + b[1] * v[1] + b[2] * v[2]);
  return sum[0] + sum[1];
}

void BoundedSolver::Jacobian::push(Moved& first, Moved& second, double impulse) const {
  const Pair to_first{first.inverse_mass * impulse, impulse}, to_second{second.inverse_mass * impulse, impulse};
  for (std::size_t k = 0; k < 3; ++k) {
    first.velocity[k] += a[k] * to_first;
    second.velocity[k] += b[k] * to_second;
  }
}

void BoundedSolver::Sweep::add(double velocity, double impulse) {
  largest = std::max(largest, std::abs(velocity));
  change += velocity * impulse;
}

/// Changes a row's impulse within its limits.
void BoundedSolver::resolve(Moved& a, Moved& b, const Jacobian& jacobian, const Row& row, Limits limits,
                            Impulse& impulse, Sweep& sweep) {
  const double start = impulse.go_on(sweep.momentum);
  double change = -row.mass * (row.velocity + jacobian.velocity(a, b));
  double wanted = start + change;
  if (wanted < limits.lower || wanted > limits.upper) {
    wanted = wanted < limits.lower ? limits.lower : limits.upper;
    change = wanted - start;
  }
  if (change == 0.0) return;
  impulse.now = wanted;
  jacobian.push(a, b, change);
  sweep.add(change / row.mass, change);
}

/// Eq. 6 as a disc (docs/theory/dynamics.md, (C2)): the impulse that stops the slip where the disc holds it, else a
/// step against the slip and back to the disc. Counts no less than the change of relative velocity.
void BoundedSolver::resolve_friction(Moved& a, Moved& b, double radius, Friction& friction, Sweep& sweep) {
  auto& [first, second] = friction.impulses;
  const Vec2 before{first.go_on(sweep.momentum), second.go_on(sweep.momentum)};
  if (radius == 0.0 && before == Vec2{}) return;
  const auto& [along_first, along_second] = friction.rows;
  const Jacobian jacobian_first(friction.directions_a[0], friction.directions_b[0], along_first);
  const Jacobian jacobian_second(friction.directions_a[1], friction.directions_b[1], along_second);
  const Vec2 slip{along_first.velocity + jacobian_first.velocity(a, b),
                  along_second.velocity + jacobian_second.velocity(a, b)};
  Vec2 wanted = before - Vec2{along_first.mass * slip.x + friction.coupling * slip.y,
                              friction.coupling * slip.x + along_second.mass * slip.y};
  if (dot(wanted, wanted) > radius * radius) {
    const Vec2 towards = before - friction.least_mass * slip;
    wanted = std::min(1.0, radius / std::sqrt(dot(towards, towards))) * towards;
  }
  const Vec2 change = wanted - before;
  first.now = wanted.x;
  second.now = wanted.y;
  jacobian_first.push(a, b, change.x);
  jacobian_second.push(a, b, change.y);
  const double most = std::abs(change.x) + std::abs(change.y);
  sweep.add(most / friction.least_mass, most);
}

void BoundedSolver::sweep_joints(Sweep& sweep) {
  for (Joint& joint : joints_) {
    Moved &a = moved_[joint.first], &b = moved_[joint.second];
    const Jacobian jacobian(joint.direction_a, joint.direction_b, joint.row);
    const double start = joint.impulse.go_on(sweep.momentum);
    const double missing = joint.row.velocity + jacobian.velocity(a, b) + joint.softness * start;
    joint.impulse.now = std::clamp(start - joint.row.mass * missing, joint.least, joint.most);
    const double change = joint.impulse.now - start;
    if (change == 0.0) continue;
    jacobian.push(a, b, change);
    sweep.add(change / joint.row.mass, change);
  }
}

void BoundedSolver::sweep_normals(Sweep& sweep) {
  rubbing_.clear();
  std::size_t i = 0;
  for (const Contact& contact : contacts_) {
    Moved &a = moved_[contact.first], &b = moved_[contact.second];
    for (const std::size_t end = i + contact.n_points; i < end; ++i) {
      const Row& row = normals_[i];
      const Jacobian jacobian(contact.direction_a, contact.direction_b, row);
      if (borne_[i] == 0 && row.velocity + jacobian.velocity(a, b) >= 0.0) continue;
      borne_[i] = 1;
      Bearing& bearing = bearings_[i];
      resolve(a, b, jacobian, row, {0.0, bearing.bound}, bearing.impulse, sweep);
      const double radius = contact.friction * bearing.impulse.now;
      if (bearing.friction == kNone && radius > 0.0) bearing.friction = add_friction(contact, positions_[i]);
      if (bearing.friction != kNone) rubbing_.push_back({bearing.friction, radius});
    }
  }
}

void BoundedSolver::sweep_frictions(Sweep& sweep) {
  for (const auto& [number, radius] : rubbing_) {
    Friction& friction = frictions_[number];
    resolve_friction(moved_[friction.first], moved_[friction.second], radius, friction, sweep);
  }
}

void BoundedSolver::sweep_partings(Sweep& sweep) {
  constexpr Limits kPush{0.0, std::numeric_limits<double>::infinity()};
  for (Parting& p : partings_)
    resolve(parted_[p.first], parted_[p.second], Jacobian(p.direction_a, p.direction_b, p.row), p.row, kPush, p.impulse,
            sweep);
}

/// Sweeps with `rows` over impulses that move `bodies`. @return the largest change of a relative velocity in the last
/// sweep [m/s].
template <typename Rows>
double BoundedSolver::iterate(std::vector<Moved>& bodies, int iterations, double still, Rows&& rows) {
  velocities_before_.assign(bodies.size(), {});
  Sweep last{.largest = std::numeric_limits<double>::infinity(), .change = 0.0};
  double momentum = 0.0;
  for (int i = 0; i < iterations && last.largest > still; ++i) {
    Sweep sweep{.momentum = momentum};
    for (std::size_t body = 0; body < bodies.size(); ++body) bodies[body].go_on(momentum, velocities_before_[body]);
    rows(sweep);
    momentum = sweep.change < last.change ? most_momentum(iterations) : 0.0;
    last = sweep;
  }
  return last.largest;
}

double BoundedSolver::solve(int iterations, double still) {
  moved_.clear();
  for (const SolverBody& body : bodies_) moved_.push_back({.velocity = {}, .inverse_mass = body.inverse_mass});
  parted_ = moved_;
  if (!partings_.empty()) iterate(parted_, iterations, still, [this](Sweep& sweep) { sweep_partings(sweep); });
  return iterate(moved_, iterations, still, [this](Sweep& sweep) {
    sweep_joints(sweep);
    sweep_normals(sweep);
    sweep_frictions(sweep);
  });
}

void BoundedSolver::Moved::go_on(double momentum, Spatial& before) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Pair now = velocity[k];
    velocity[k] += momentum * (now - before[k]);
    before[k] = now;
  }
}

Twist BoundedSolver::Moved::twist(const SolverBody& body) const {
  const auto& [x, y, z] = velocity;
  const auto& axes = body.axes;
  return {body.stretched({x[0], y[0], z[0]}), x[1] * axes[0] + y[1] * axes[1] + z[1] * axes[2]};
}

Twist BoundedSolver::twist(std::uint32_t body) const {
  const Twist before = bodies_[body].twist;
  const Twist change = moved_[body].twist(bodies_[body]);
  return {before.linear + change.linear, before.angular + change.angular};
}

Twist BoundedSolver::parting(std::uint32_t body) const { return parted_[body].twist(bodies_[body]); }

PointImpulse BoundedSolver::impulse(std::size_t point) const {
  const Bearing& bearing = bearings_[point];
  PointImpulse result{.normal = bearing.impulse.now, .at_bound = bearing.impulse.now >= bearing.bound};
  if (bearing.friction == kNone) return result;
  const Friction& friction = frictions_[bearing.friction];
  for (std::size_t k = 0; k < 2; ++k) result.friction += friction.impulses[k].now * friction.tangents[k];
  return result;
}

}  // namespace brash::rigid_body
