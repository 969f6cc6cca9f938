// SPDX-License-Identifier: GPL-3.0-or-later
// Long strides of the bounded solver, where heavy bodies touch light ones (docs/theory/contacts-and-bodies.md, (C8)).
#include <algorithm>
#include <cmath>
#include <numeric>

#include "bounded_solver.hpp"

namespace brash::rigid_body {
namespace {

/// A contact of bodies whose masses differ by this factor needs long strides [-]: a sweep passes on about the light
/// body's mass times the heavy body's velocity. Momentum is enough below it.
constexpr double kHeavyAndLight = 250.0;
/// A stride is long if it continues by more than this many times the last sweep's change; momentum is enough below [-].
constexpr double kLongStride = 30.0;
/// The share that remains of a stride that would raise the energy [-].
constexpr double kShorter = 0.25;

std::uint32_t root_of(std::vector<std::uint32_t>& parents, std::uint32_t body) {
  while (parents[body] != body) body = parents[body] = parents[parents[body]];
  return body;
}

/// The stride, if it is long; else none.
double long_stride(double stride) { return stride > kLongStride ? stride : 0.0; }

}  // namespace

/// Numbers the groups of bodies that contacts connect, if a heavy body touches a light one in them. Joints have terms
/// of their own, and steps with joints take no strides.
void BoundedSolver::find_groups() {
  groups_.clear();
  const auto is_heavy_on_light = [&](const Ends& ends) {
    const double a = bodies_[ends.first].inverse_mass, b = bodies_[ends.second].inverse_mass;
    return a > 0.0 && b > 0.0 && std::max(a, b) > kHeavyAndLight * std::min(a, b);
  };
  if (!joints_.empty() || std::ranges::none_of(ends_, is_heavy_on_light)) return;
  std::vector<std::uint32_t> parents(bodies_.size());
  std::iota(parents.begin(), parents.end(), 0u);
  for (const Ends& ends : ends_)
    if (ends.first != kFixed && ends.second != kFixed)
      parents[root_of(parents, ends.first)] = root_of(parents, ends.second);
  group_of_.assign(moved_.size(), kNone);
  for (const Ends& ends : ends_) {
    std::uint32_t& group = group_of_[root_of(parents, ends.first)];
    if (!is_heavy_on_light(ends) || group != kNone) continue;
    group = static_cast<std::uint32_t>(groups_.size());
    groups_.emplace_back();
  }
  for (std::uint32_t body = 1; body < bodies_.size(); ++body) group_of_[body] = group_of_[root_of(parents, body)];
}

/// Calls `visit(group, strip, contact, point)` for each point of a group that has carried something.
template <typename Visit>
void BoundedSolver::each_point_of_groups(Visit&& visit) {
  for (std::size_t n = 0; n <= order_.n(); ++n) {
    Strip& strip = strips_[n];
    std::size_t point = strip.first_point;
    for (const Contact& contact : std::span(contacts_).subspan(strip.first_contact, strip.n_contacts)) {
      const std::uint32_t of_a = group_of_[contact.bodies.a],
                          group = of_a != kNone ? of_a : group_of_[contact.bodies.b];
      for (std::uint32_t k = 0; k < contact.n_points; ++k, ++point)
        if (group != kNone && borne_[point] != 0) visit(groups_[group], strip, contact, point);
    }
  }
}

/// Calls `visit(group, body)` for each body of a group.
template <typename Visit>
void BoundedSolver::each_body_of_groups(Visit&& visit) {
  for (std::size_t body = 1; body < bodies_.size(); ++body)
    if (group_of_[body] != kNone) visit(groups_[group_of_[body]], body);
}

/// Twice the kinetic energy of two changes of a body's velocity, the first times the second [J].
double BoundedSolver::energy(const Moved& body, const Spatial& first, const Spatial& second) {
  const double mass = body.inverse_mass > 0.0 ? 1.0 / body.inverse_mass : 0.0;
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) sum += mass * first[k][0] * second[k][0] + first[k][1] * second[k][1];
  return sum;
}

/// The stride of each group at which the energy of its impulses is least on the line of the last sweep's change.
void BoundedSolver::aim_strides() {
  for (Group& group : groups_) group = {};
  each_point_of_groups([&](Group& group, const Strip& strip, const Contact&, std::size_t point) {
    const Bearing& bearing = bearings_[point];
    group.slope += bearing.impulse.last_change() * normals_[point].velocity;
    if (bearing.friction == kNone) return;
    const Friction& friction = strip.frictions[bearing.friction];
    for (std::size_t k = 0; k < 2; ++k) group.slope += friction.impulses[k].last_change() * friction.rows[k].velocity;
  });
  each_body_of_groups([&](Group& group, std::size_t body) {
    const Spatial &now = moved_[body].velocity, &before = velocities_before_[body];
    const Spatial change{now[0] - before[0], now[1] - before[1], now[2] - before[2]};
    group.slope += energy(moved_[body], change, now);
    group.curvature += energy(moved_[body], change, change);
  });
  for (Group& group : groups_) group.stride = long_stride(group.curvature > 0.0 ? -group.slope / group.curvature : 0.0);
}

/// Ends each stride where the first normal impulse comes to a bound. An impulse that is as near to its bound as
/// momentum leads stays there.
void BoundedSolver::stop_strides_at_bounds() {
  each_point_of_groups([&](Group& group, const Strip&, const Contact&, std::size_t point) {
    const auto& [impulse, bound, friction] = bearings_[point];
    const double change = impulse.last_change();
    if (change == 0.0) return;
    const double to_bound = ((change > 0.0 ? bound : 0.0) - impulse.now) / change;
    if (to_bound > kLongStride) group.stride = std::min(group.stride, to_bound);
  });
}

/// Where a group's stride leads a point, within the point's bounds: normal impulse and friction [N s].
BoundedSolver::Stridden BoundedSolver::stridden(const Group& group, const Strip& strip, const Contact& contact,
                                                std::size_t point) const {
  const Bearing& bearing = bearings_[point];
  Stridden to{.normal = std::clamp(bearing.impulse.beyond(group.stride), 0.0, bearing.bound)};
  if (bearing.friction == kNone) return to;
  const auto& impulses = strip.frictions[bearing.friction].impulses;
  to.friction = {impulses[0].beyond(group.stride), impulses[1].beyond(group.stride)};
  const double radius = contact.friction * to.normal, size = std::sqrt(dot(to.friction, to.friction));
  if (size > radius) to.friction = (radius / size) * to.friction;
  return to;
}

/// Moves `strides_` by the strides, and finds the change of each group's energy.
void BoundedSolver::try_strides() {
  strides_ = moved_;
  for (Group& group : groups_) group.change = 0.0;
  each_point_of_groups([&](Group& group, const Strip& strip, const Contact& contact, std::size_t point) {
    const Bearing& bearing = bearings_[point];
    const Stridden to = stridden(group, strip, contact, point);
    Moved &a = strides_[contact.bodies.a], &b = strides_[contact.bodies.b];
    const auto push = [&](Vec3 direction_a, Vec3 direction_b, const Row& row, double change) {
      group.change += change * row.velocity;
      Jacobian(direction_a, direction_b, row).push(a, b, change);
    };
    push(contact.direction_a, contact.direction_b, normals_[point], to.normal - bearing.impulse.now);
    if (bearing.friction == kNone) return;
    const Friction& friction = strip.frictions[bearing.friction];
    const Tangents& tangents = strip.tangents[friction.tangents];
    push(tangents.directions_a[0], tangents.directions_b[0], friction.rows[0],
         to.friction.x - friction.impulses[0].now);
    push(tangents.directions_a[1], tangents.directions_b[1], friction.rows[1],
         to.friction.y - friction.impulses[1].now);
  });
  each_body_of_groups([&](Group& group, std::size_t body) {
    const Spatial &after = strides_[body].velocity, &now = moved_[body].velocity;
    group.change += 0.5 * (energy(moved_[body], after, after) - energy(moved_[body], now, now));
  });
}

/// Takes a stride in each group, as far as it lowers the energy of the group's impulses. The next sweep starts there,
/// without momentum.
void BoundedSolver::take_strides() {
  aim_strides();
  stop_strides_at_bounds();
  const auto is_taken = [](const Group& group) { return group.stride > 0.0; };
  const auto is_too_far = [&](const Group& group) { return is_taken(group) && group.change > 0.0; };
  if (std::ranges::none_of(groups_, is_taken)) return;
  for (try_strides(); std::ranges::any_of(groups_, is_too_far); try_strides())
    for (Group& group : groups_)
      if (is_too_far(group)) group.stride = long_stride(kShorter * group.stride);
  each_point_of_groups([&](const Group& group, Strip& strip, const Contact& contact, std::size_t point) {
    if (!(group.stride > 0.0)) return;
    Bearing& bearing = bearings_[point];
    const Stridden to = stridden(group, strip, contact, point);
    bearing.impulse = {to.normal, to.normal};
    if (bearing.friction != kNone)
      strip.frictions[bearing.friction].impulses = {Impulse{to.friction.x, to.friction.x},
                                                    {to.friction.y, to.friction.y}};
  });
  each_body_of_groups([&](const Group& group, std::size_t body) {
    if (!(group.stride > 0.0)) return;
    moved_[body].velocity = velocities_before_[body] = strides_[body].velocity;
  });
}

}  // namespace brash::rigid_body
