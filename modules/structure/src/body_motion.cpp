// SPDX-License-Identifier: GPL-3.0-or-later
// docs/theory/structures.md, (B2), (B3), (B4), (B5), (B6), (B12), (B13).
#include "body_motion.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/core/error.hpp"
#include "rotation.hpp"

namespace brash::structure {
namespace {

Vec3 times(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
Vec3 over(Vec3 a, Vec3 b) { return {a.x / b.x, a.y / b.y, a.z / b.z}; }
Vec3 inwards(const Quaternion& q, Vec3 v) { return rotate(conjugate(q), v); }

/// b v + c |v| v for each component.
Vec3 drag(Vec3 linear, Vec3 quadratic, Vec3 v) {
  return times(linear, v) + times(quadratic, {std::abs(v.x) * v.x, std::abs(v.y) * v.y, std::abs(v.z) * v.z});
}

/// The velocity v with m v + t (b v + c |v| v) = momentum, exactly.
double slowed(double momentum, double m, double b, double c, double t) {
  const double a = m + t * b;
  return 2.0 * momentum / (a + std::sqrt(a * a + 4.0 * t * c * std::abs(momentum)));
}
Vec3 slowed(Vec3 momentum, Vec3 m, Vec3 b, Vec3 c, double t) {
  return {slowed(momentum.x, m.x, b.x, c.x, t), slowed(momentum.y, m.y, b.y, c.y, t),
          slowed(momentum.z, m.z, b.z, c.z, t)};
}

/// The body with the loss of its thrust as damping in surge, which is implicit and stable at any step.
model::FloatingBody with_falling_thrust(model::FloatingBody body) {
  if (!body.open_water_speed) return body;
  const auto [linear, quadratic] = model::thrust_loss(body.thrust.x, *body.open_water_speed);
  body.linear_damping.x += linear;
  body.quadratic_damping.x += quadratic;
  return body;
}

}  // namespace

BodyMotion::BodyMotion(const model::FloatingBody& body, const std::optional<model::Moored>& moored, const State& start,
                       const Surroundings& around)
    : Motion(start),
      hull_(&around.hull),
      inertia_(inertia_of(body, around.hull, around.water_density)),
      body_(with_falling_thrust(body)),
      density_(around.water_density),
      current_{around.current.x, around.current.y, 0.0},
      time_step_(around.time_step),
      mass_(Vec3{inertia_.mass, inertia_.mass, inertia_.mass} + inertia_.added_mass),
      moments_(inertia_.moments + inertia_.added_inertia) {
  if (moored) {
    mooring_.emplace(*moored, start.pose);
    feet_ = {moored->speed, 0.0, 0.0};
  }
  const Quaternion& q = start.pose.rotation;
  spin_ = inwards(q, start.twist.angular);
  velocity_ = inwards(q, velocity_at(start.twist, rotate(q, inertia_.centre)) - current_);
  const Loads loads = loads_at(start.pose);
  hydrostatic_at_start_ = loads.hydrostatic;
  mooring_at_start_ = loads.mooring;
  anchor_power_ = loads.anchor_power;
  Momenta p = momenta(q);
  initial_ = energy_.kinetic = kinetic(p, q);
  expect_stable(around.time_step);
  // Half a step ahead: the water's load acts in that half alone.
  p.linear += 0.5 * time_step_ * loads.load.force;
  p.angular += 0.5 * time_step_ * loads.load.moment;
  leave_with(p);
}

/// Weight and buoyancy have the energy of (B6).
BodyMotion::Loads BodyMotion::loads_at(const Pose& pose, Vec3 body_thrust) const {
  const Vec3 arm = rotate(pose.rotation, inertia_.centre), centre = pose.position + arm;
  const Displacement wet = displaced_by_mesh(*hull_, pose);
  const Vec3 buoyancy{0.0, 0.0, density_ * kGravity * wet.volume};
  const Vec3 thrust = rotate(pose.rotation, body_thrust);
  Loads loads;
  loads.load.force = buoyancy + thrust - Vec3{0.0, 0.0, inertia_.mass * kGravity};
  loads.load.moment =
      cross(wet.centre - centre, buoyancy) + rotate(pose.rotation, cross(body_.thrust_arm, body_thrust));
  loads.hydrostatic = kGravity * (inertia_.mass * centre.z - density_ * wet.volume * wet.centre.z);
  if (!mooring_) return loads;
  const MooringLoad pull = mooring_->at(pose, foot_);
  loads.load.force += pull.load.force;
  loads.load.moment += pull.load.moment - cross(arm, pull.load.force);
  loads.mooring = pull.energy;
  loads.anchor_power = dot(pull.load.force, feet_ - current_);
  return loads;
}

Wrench BodyMotion::water_load() const {
  return {
      -drag(body_.linear_damping, body_.quadratic_damping, velocity_),
      -drag(body_.angular_damping, body_.quadratic_angular_damping, spin_) - cross(velocity_, times(mass_, velocity_))};
}

BodyMotion::Momenta BodyMotion::momenta(const Quaternion& attitude) const {
  return {rotate(attitude, times(mass_, velocity_)), rotate(attitude, times(moments_, spin_))};
}

double BodyMotion::kinetic(const Momenta& p, const Quaternion& attitude) const {
  const Vec3 linear = inwards(attitude, p.linear), angular = inwards(attitude, p.angular);
  return 0.5 * (dot(linear, over(linear, mass_)) + dot(angular, over(angular, moments_)));
}

/// The attitude in the middle of the step depends on the spin, and the spin on that attitude: a few rounds find both
/// (B5). Each round brings them nearer by the angle of half a step.
void BodyMotion::leave_with(const Momenta& p) {
  constexpr int kMostRounds = 50;
  constexpr double kClose = 1e-15;
  const Quaternion& q = now_.pose.rotation;
  const double half = 0.5 * time_step_;
  for (int round = 0; round < kMostRounds; ++round) {
    const Quaternion middle = product(q, rotation_by(half * spin_));
    const Vec3 turning = -half * cross(velocity_, times(mass_, velocity_));
    const Vec3 v = slowed(inwards(middle, p.linear), mass_, body_.linear_damping, body_.quadratic_damping, half);
    const Vec3 w = slowed(inwards(middle, p.angular) + turning, moments_, body_.angular_damping,
                          body_.quadratic_angular_damping, half);
    const bool is_found = norm(v - velocity_) <= kClose * norm(v) && norm(w - spin_) <= kClose * norm(w);
    velocity_ = v;
    spin_ = w;
    if (is_found) break;
  }
  const Quaternion middle = product(q, rotation_by(half * spin_));
  const Quaternion end = normalized(product(q, rotation_by(time_step_ * spin_)));
  const Vec3 way = time_step_ * (rotate(middle, velocity_) + current_);
  const Vec3 of_origin = way + rotate(q, inertia_.centre) - rotate(end, inertia_.centre);
  now_.twist = {of_origin / time_step_, rotate(q, spin_)};
}

State BodyMotion::after(double share) const {
  const double time = share * time_step_;
  return {{now_.pose.position + time * now_.twist.linear, turned(now_.pose.rotation, time * now_.twist.angular)},
          now_.twist};
}

void BodyMotion::advance(double share) {
  Motion::advance(share);
  foot_ += share * time_step_ * feet_;
}

void BodyMotion::book_works(const Loads& loads) {
  const Wrench water = water_load();
  const Quaternion middle = product(now_.pose.rotation, rotation_by(-0.5 * time_step_ * spin_));
  const Vec3 v = rotate(middle, velocity_), w = rotate(middle, spin_);
  energy_.ice_work += time_step_ * (dot(ice_.force, v) + dot(ice_.moment, w));
  energy_.thrust_work +=
      time_step_ * (dot(body_.thrust, velocity_) + dot(cross(body_.thrust_arm, body_.thrust), spin_));
  // The turning moment moves energy between the motions, and takes none.
  const Vec3 turning = cross(velocity_, times(mass_, velocity_));
  energy_.damping_loss -= time_step_ * (dot(water.force, velocity_) + dot(water.moment + turning, spin_));
  energy_.anchor_work += 0.5 * time_step_ * (anchor_power_ + loads.anchor_power);
  anchor_power_ = loads.anchor_power;
}

void BodyMotion::bear(const Wrench& load) {
  const Quaternion& q = now_.pose.rotation;
  const double half = 0.5 * time_step_;
  const Loads loads = loads_at(now_.pose);
  book_works(loads);

  // From the middle of the step to its end (B3).
  const Quaternion middle = product(q, rotation_by(-half * spin_));
  const Wrench water = water_load();
  Momenta p = momenta(middle);
  p.linear += half * (rotate(middle, water.force) + loads.load.force + ice_.force);
  p.angular += half * (rotate(middle, water.moment) + loads.load.moment + ice_.moment);
  energy_.kinetic = kinetic(p, q);
  energy_.hydrostatic = loads.hydrostatic - hydrostatic_at_start_;
  energy_.mooring = loads.mooring - mooring_at_start_;
  energy_.error = initial_ + energy_.ice_work + energy_.thrust_work + energy_.anchor_work - energy_.kinetic -
                  energy_.hydrostatic - energy_.mooring - energy_.damping_loss;

  // From there to the middle of the next one.
  ice_ = {load.force, load.moment - cross(rotate(q, inertia_.centre), load.force)};
  p.linear += half * (loads.load.force + ice_.force);
  p.angular += half * (loads.load.moment + ice_.moment);
  leave_with(p);
}

Vec2 BodyMotion::course() const {
  if (mooring_ && plan(feet_) != Vec2{}) return plan(feet_);
  return plan(rotate(now_.pose.rotation, {1.0, 0.0, 0.0}));
}

std::array<std::array<double, 6>, 6> BodyMotion::stiffness_over_mass(Vec3 thrust) const {
  const std::array<double, 6> inertia{mass_.x, mass_.y, mass_.z, moments_.x, moments_.y, moments_.z};
  const double size = std::cbrt(inertia_.mass / density_), small = 1e-4;
  const Pose& at = now_.pose;
  std::array<std::array<double, 6>, 6> stiffness{};
  for (std::size_t j = 0; j < 6; ++j) {
    std::array<double, 6> step{};
    step[j] = j < 3 ? small * size : small;
    const auto load_at = [&](double sign) {
      const Quaternion q = turned(at.rotation, {sign * step[3], sign * step[4], sign * step[5]});
      const Vec3 centre = to_world(at, inertia_.centre) + sign * Vec3{step[0], step[1], step[2]};
      return loads_at({centre - rotate(q, inertia_.centre), q}, thrust).load;
    };
    const Wrench more = load_at(1.0), less = load_at(-1.0);
    const Vec3 force = (more.force - less.force) / (2.0 * step[j]),
               moment = (more.moment - less.moment) / (2.0 * step[j]);
    const std::array<double, 6> column{force.x, force.y, force.z, moment.x, moment.y, moment.z};
    for (std::size_t i = 0; i < 6; ++i) stiffness[i][j] = -column[i] / std::sqrt(inertia[i] * inertia[j]);
  }
  return stiffness;
}

/// Weight, buoyancy and mooring have a potential, so their stiffness about a pose of rest is symmetric; the rest of it
/// is left out (B12). A thrust follows the body: it has no potential, and restores nothing.
std::vector<NaturalMode> BodyMotion::natural_modes() const {
  constexpr std::array<const char*, 6> kMotions{"surge", "sway", "heave", "roll", "pitch", "yaw"};
  constexpr double kNothing = 1e-7;  // of the largest: what the differences leave of a stiffness of 0
  const auto stiffness = stiffness_over_mass({});
  Eigen::Matrix<double, 6, 6> symmetric;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      symmetric(i, j) = 0.5 * (stiffness[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] +
                               stiffness[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)]);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solved(symmetric);
  const double largest = solved.eigenvalues().cwiseAbs().maxCoeff();
  std::vector<NaturalMode> modes;
  for (int i = 0; i < 6; ++i) {
    if (std::abs(solved.eigenvalues()[i]) <= kNothing * largest) continue;
    Eigen::Index most = 0;
    solved.eigenvectors().col(i).cwiseAbs().maxCoeff(&most);
    modes.push_back({kMotions[static_cast<std::size_t>(most)], solved.eigenvalues()[i]});
  }
  return modes;
}

Settling BodyMotion::settling() const {
  const auto stiffness = stiffness_over_mass(body_.thrust);
  const Wrench load = loads_at(now_.pose).load;
  const Eigen::Vector3d roots = Eigen::Array3d(mass_.z, moments_.x, moments_.y).sqrt();
  const Eigen::Vector3d scaled = Eigen::Array3d(load.force.z, load.moment.x, load.moment.y) / roots.array();
  constexpr std::size_t kHeave = 2;
  Eigen::Matrix3d restoring;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      restoring(static_cast<int>(i), static_cast<int>(j)) = stiffness[kHeave + i][kHeave + j];
  const Eigen::Vector3d way = restoring.fullPivLu().solve(scaled).cwiseQuotient(roots);
  return {way.x(), way.y(), way.z()};
}

/// The leapfrog is stable below 2 / omega (B4), with the highest frequency of the restoring loads. It is bounded by the
/// columns of the stiffness over the masses (Gershgorin 1931).
void BodyMotion::expect_stable(double time_step) const {
  const auto stiffness = stiffness_over_mass(body_.thrust);
  double largest = 0.0;
  for (std::size_t j = 0; j < 6; ++j) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 6; ++i) sum += std::abs(stiffness[i][j]);
    largest = std::max(largest, sum);
  }
  const double limit = 2.0 / std::sqrt(largest);
  if (time_step < limit) return;
  throw InputError(Complaint{fmt::format("time.step = {}", time_step),
                             "is too long for the structure on its restoring loads",
                             fmt::format("less than {:.4g} s", limit), "shorten the step, or soften the mooring"});
}

void BodyMotion::save(model::Checkpoint& checkpoint) const {
  Motion::save(checkpoint);
  model::save(checkpoint, "floating_body", *this);
}

void BodyMotion::restore(const model::Checkpoint& checkpoint) {
  Motion::restore(checkpoint);
  model::restore(checkpoint, "floating_body", *this);
}

}  // namespace brash::structure
