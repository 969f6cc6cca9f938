// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the bounded solver: made before the sweeps, and friction when a point first carries something.
#include <algorithm>
#include <cmath>

#include "bounded_solver.hpp"
#include "convex_part.hpp"

namespace brash::rigid_body {
namespace {

/// A matrix of two directions has one in which nothing gives way, if its determinant over its squared trace is below
/// this [-]. Free bodies have 1e-3 and more, and sheets in the plane round-off.
constexpr double kOneWay = 1e-12;

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
  joints_.clear();
  given_.clear();
  copies_.clear();
}

std::uint32_t BoundedSolver::add(const SolverBody& body) {
  bodies_.push_back(body);
  return static_cast<std::uint32_t>(bodies_.size() - 1);
}

void BoundedSolver::add(const SolverContact& contact, std::span<const PatchPoint> points) {
  given_.push_back({contact, copies_.emplace_back(points.begin(), points.end())});
}

std::size_t BoundedSolver::n_points() const {
  std::size_t sum = 0;
  for (const Given& given : given_) sum += given.points.size();
  return sum;
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

BoundedSolver::Arms BoundedSolver::arms(const SolverContact& contact, Vec3 position) const {
  const SolverBody &a = bodies_[contact.first], &b = bodies_[contact.second];
  return {a, b, position - a.position, position - b.position};
}

bool BoundedSolver::is_moved(std::uint32_t body) const {
  const SolverBody& b = bodies_[body];
  return b.inverse_mass != 0.0 || b.axes != std::array<Vec3, 3>{};
}

/// The order of all contacts, and room for their rows.
void BoundedSolver::divide_into_strips() {
  ends_.clear();
  for (const auto& [contact, points] : given_)
    ends_.push_back({is_moved(contact.first) ? contact.first : 0, is_moved(contact.second) ? contact.second : 0});
  order_.lay(ends_, bodies_.size() - 1);
  strips_.resize(std::max(strips_.size(), order_.n() + 1));
  first_points_.assign(1, 0);
  for (const Given& given : given_) first_points_.push_back(first_points_.back() + given.points.size());
  const std::size_t n_points = first_points_.back();
  std::size_t point = 0;
  for (std::size_t i = 0; i <= order_.n(); ++i) {
    Strip& strip = strips_[i];
    strip.first_contact = order_.begin(i);
    strip.first_point = point;
    strip.n_contacts = order_.contacts_of(i).size();
    for (const std::uint32_t contact : order_.contacts_of(i))
      point += first_points_[contact + 1] - first_points_[contact];
  }
  contacts_.resize(given_.size());
  normals_.resize(n_points);
  borne_.assign(n_points, 0);
  bearings_.resize(n_points);
  places_.resize(n_points);
}

/// The rows of a strip.
void BoundedSolver::fill(std::size_t number) {
  Strip& strip = strips_[number];
  strip.tangents.clear();
  strip.frictions.clear();
  strip.partings.clear();
  const auto still = static_cast<std::uint32_t>(bodies_.size() + number);
  std::size_t point = strip.first_point, place = strip.first_contact;
  for (const std::uint32_t i : order_.contacts_of(number)) {
    const auto& [given, points] = given_[i];
    const Bodies bodies{ends_[i].first != 0 ? ends_[i].first : still, ends_[i].second != 0 ? ends_[i].second : still};
    contacts_[place++] = {.direction_a = bodies_[given.first].stretched(given.normal),
                          .direction_b = bodies_[given.second].stretched(-given.normal),
                          .friction = given.friction,
                          .bodies = bodies,
                          .n_points = static_cast<std::uint32_t>(points.size()),
                          .number = i};
    for (std::size_t k = 0; k < points.size(); ++k, ++point) {
      places_[first_points_[i] + k] = {static_cast<std::uint32_t>(point), static_cast<std::uint32_t>(number), i};
      fill_point(point, strip, given, bodies, points[k]);
    }
  }
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

void BoundedSolver::fill_point(std::size_t point, Strip& strip, const SolverContact& contact, Bodies bodies,
                               const PatchPoint& at) {
  Row& normal = normals_[point] = row(arms(contact, at.position), contact.normal);
  bearings_[point] = {};
  if (std::isfinite(contact.crushing_impulse)) bearings_[point].bound = contact.crushing_impulse * at.area;
  if (contact.parting_speed > 0.0) {
    strip.partings.push_back({bodies_[contact.first].stretched(contact.normal),
                              bodies_[contact.second].stretched(-contact.normal),
                              normal,
                              {},
                              bodies});
    strip.partings.back().row.velocity = -contact.parting_speed;
  }
  normal.velocity *= 1.0 + restitution_;
}

/// @param point  of the contact. @return its number.
std::uint32_t BoundedSolver::add_friction(Strip& strip, Contact& contact, std::size_t point) const {
  const auto& [given, points] = given_[contact.number];
  const Arms from_centres = arms(given, points[point].position);
  const std::array<Vec3, 2> tangents = plane_axes(given.normal);
  if (contact.tangents == kNone) {
    contact.tangents = static_cast<std::uint32_t>(strip.tangents.size());
    const auto of_a = [&](Vec3 t) { return from_centres.first.stretched(t); };
    const auto of_b = [&](Vec3 t) { return from_centres.second.stretched(-t); };
    strip.tangents.push_back(
        {{of_a(tangents[0]), of_a(tangents[1])}, {of_b(tangents[0]), of_b(tangents[1])}, contact.bodies});
  }
  Friction& friction = strip.frictions.emplace_back();
  friction.tangents = contact.tangents;
  for (std::size_t k = 0; k < 2; ++k) {
    friction.rows[k] = row(from_centres, tangents[k]);
    friction.rows[k].velocity *= 1.0 + restitution_;
  }
  auto& [first, second] = friction.rows;
  // Slip per impulse in the first direction, in the second, and in one per impulse in the other.
  const double give_first = 1.0 / first.mass, give_second = 1.0 / second.mass;
  double across = mobility_across(from_centres.first, tangents[0], tangents[1]) +
                  mobility_across(from_centres.second, tangents[0], tangents[1]);
  for (std::size_t i = 0; i < 3; ++i) across += first.turn_a[i] * second.turn_a[i] + first.turn_b[i] * second.turn_b[i];
  const double determinant = give_first * give_second - across * across, trace = give_first + give_second;
  if (determinant > kOneWay * trace * trace) {
    first.mass = give_second / determinant;
    second.mass = give_first / determinant;
    friction.coupling = -across / determinant;
  } else {  // the bodies give way in one direction alone: the pseudoinverse
    first.mass = give_first / (trace * trace);
    second.mass = give_second / (trace * trace);
    friction.coupling = across / (trace * trace);
  }
  friction.least_mass = 2.0 / (give_first + give_second + std::hypot(give_first - give_second, 2.0 * across));
  return static_cast<std::uint32_t>(strip.frictions.size() - 1);
}

}  // namespace brash::rigid_body
