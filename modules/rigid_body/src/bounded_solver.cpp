// SPDX-License-Identifier: GPL-3.0-or-later
#include "bounded_solver.hpp"

#include <algorithm>
#include <cmath>

#include "brash/core/interruption.hpp"
#include "convex_part.hpp"

namespace brash::rigid_body {
namespace {

/// Of the sweeps of a step, as long as they change less and less: it lasts for a tenth of the sweeps
/// (docs/theory/contacts-and-bodies.md, (C3)).
double most_momentum(int iterations) { return std::max(0.0, 1.0 - 10.0 / iterations); }

/// Sweeps before the first long stride and between two, in which the light bodies come to rest.
constexpr int kBetweenStrides = 8;
/// Sweeps after the last stride.
constexpr int kAfterStrides = 8;

/// Bodies that a thread takes at a time, at some 10 ns for each.
constexpr std::size_t kBodies = 512;

}  // namespace

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

void BoundedSolver::Sweep::add(const Sweep& part) {
  largest = std::max(largest, part.largest);
  change += part.change;
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

/// Eq. 6 as a disc (docs/theory/contacts-and-bodies.md, (C2)): the impulse that stops the slip where the disc holds it,
/// else a step against the slip and back to the disc. Counts no less than the change of relative velocity.
void BoundedSolver::resolve_friction(Moved& a, Moved& b, double radius, const Tangents& tangents, Friction& friction,
                                     Sweep& sweep) {
  auto& [first, second] = friction.impulses;
  const Vec2 before{first.go_on(sweep.momentum), second.go_on(sweep.momentum)};
  if (radius == 0.0 && before == Vec2{}) return;
  const auto& [along_first, along_second] = friction.rows;
  const Jacobian jacobian_first(tangents.directions_a[0], tangents.directions_b[0], along_first);
  const Jacobian jacobian_second(tangents.directions_a[1], tangents.directions_b[1], along_second);
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

void BoundedSolver::sweep_normals(Strip& strip) {
  strip.rubbing.clear();
  std::size_t i = strip.first_point;
  for (Contact& contact : std::span(contacts_).subspan(strip.first_contact, strip.n_contacts)) {
    Moved &a = moved_[contact.bodies.a], &b = moved_[contact.bodies.b];
    for (std::uint32_t k = 0; k < contact.n_points; ++k, ++i) {
      const Row& row = normals_[i];
      const Jacobian jacobian(contact.direction_a, contact.direction_b, row);
      if (borne_[i] == 0 && row.velocity + jacobian.velocity(a, b) >= 0.0) continue;
      borne_[i] = 1;
      Bearing& bearing = bearings_[i];
      resolve(a, b, jacobian, row, {0.0, bearing.bound}, bearing.impulse, strip.sweep);
      const double radius = contact.friction * bearing.impulse.now;
      if (bearing.friction == kNone && radius > 0.0) bearing.friction = add_friction(strip, contact, k);
      if (bearing.friction != kNone) strip.rubbing.push_back({bearing.friction, radius});
    }
  }
}

void BoundedSolver::sweep_frictions(Strip& strip) {
  for (const auto& [number, radius] : strip.rubbing) {
    Friction& friction = strip.frictions[number];
    const Tangents& tangents = strip.tangents[friction.tangents];
    resolve_friction(moved_[tangents.bodies.a], moved_[tangents.bodies.b], radius, tangents, friction, strip.sweep);
  }
}

void BoundedSolver::sweep_partings(Strip& strip) {
  constexpr Limits kPush{0.0, std::numeric_limits<double>::infinity()};
  for (Parting& p : strip.partings)
    resolve(parted_[p.bodies.a], parted_[p.bodies.b], Jacobian(p.direction_a, p.direction_b, p.row), p.row, kPush,
            p.impulse, strip.sweep);
}

/// Every second strip, then the others, then the rest.
template <typename Task>
void BoundedSolver::each_strip(Workers& workers, Task&& task) {
  const std::size_t n = order_.n();
  workers.each((n + 1) / 2, 1, [&](std::size_t i) { task(strips_[2 * i]); });
  workers.each(n / 2, 1, [&](std::size_t i) { task(strips_[2 * i + 1]); });
  task(strips_[n]);
}

/// Sweeps with `rows` over impulses that move `bodies`, and calls `after_sweep` with the number of each sweep from 0.
/// @return the largest change of a relative velocity in the last sweep [m/s].
template <typename Rows, typename After>
double BoundedSolver::iterate(std::vector<Moved>& bodies, int iterations, double still, Workers& workers, Rows&& rows,
                              After&& after_sweep) {
  velocities_before_.assign(bodies_.size(), {});
  Sweep last{.largest = std::numeric_limits<double>::infinity(), .change = 0.0};
  double momentum = 0.0;
  for (int i = 0; i < iterations && last.largest > still; ++i) {
    look_for_interruption();
    Sweep sweep{.momentum = momentum};
    for (std::size_t k = 0; k <= order_.n(); ++k) strips_[k].sweep = sweep;
    workers.each(bodies_.size(), kBodies,
                 [&](std::size_t body) { bodies[body].go_on(momentum, velocities_before_[body]); });
    rows(sweep);
    for (std::size_t k = 0; k <= order_.n(); ++k) sweep.add(strips_[k].sweep);
    momentum = sweep.change < last.change ? most_momentum(iterations) : 0.0;
    last = sweep;
    after_sweep(i);
  }
  return last.largest;
}

double BoundedSolver::solve(int iterations, double still, Workers& workers) {
  divide_into_strips();
  const std::size_t n_strips = order_.n() + 1;
  workers.each(n_strips, 1, [this](std::size_t i) { fill(i); });
  moved_.assign(bodies_.size() + n_strips, {});
  for (std::size_t i = 0; i < bodies_.size(); ++i) moved_[i].inverse_mass = bodies_[i].inverse_mass;
  parted_ = moved_;
  const bool parts = std::any_of(strips_.begin(), strips_.begin() + static_cast<std::ptrdiff_t>(n_strips),
                                 [](const Strip& strip) { return !strip.partings.empty(); });
  if (parts)
    iterate(
        parted_, iterations, still, workers,
        [&](Sweep&) { each_strip(workers, [this](Strip& strip) { sweep_partings(strip); }); }, [](int) {});
  find_groups();
  const auto sweep_all = [&](Sweep& sweep) {
    sweep_joints(sweep);
    each_strip(workers, [this](Strip& strip) { sweep_normals(strip); });
    each_strip(workers, [this](Strip& strip) { sweep_frictions(strip); });
  };
  return iterate(moved_, iterations, still, workers, sweep_all, [&](int i) {
    const bool is_due = (i + 1) % kBetweenStrides == 0 && i + kAfterStrides < iterations;
    if (is_due && !groups_.empty()) take_strides();
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
  const Place& place = places_[point];
  const Bearing& bearing = bearings_[place.point];
  PointImpulse result{.normal = bearing.impulse.now, .at_bound = bearing.impulse.now >= bearing.bound};
  if (bearing.friction == kNone) return result;
  const Friction& friction = strips_[place.strip].frictions[bearing.friction];
  const std::array<Vec3, 2> tangents = plane_axes(given_[place.contact].contact.normal);
  for (std::size_t k = 0; k < 2; ++k) result.friction += friction.impulses[k].now * tangents[k];
  return result;
}

}  // namespace brash::rigid_body
