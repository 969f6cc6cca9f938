// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/structure/motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "body_motion.hpp"
#include "brash/core/error.hpp"
#include "brash/structure/path.hpp"
#include "rotation.hpp"

namespace brash::structure {
namespace {

/// Along the velocity in plan; where there is none, along the structure's x axis.
Vec2 way_ahead(const State& state) {
  const Vec2 velocity = plan(state.twist.linear);
  return velocity == Vec2{} ? plan(rotate(state.pose.rotation, {1.0, 0.0, 0.0})) : velocity;
}

/// At a constant speed along x.
class Towed final : public Motion {
 public:
  Towed(const model::Towed& towed, const State& start, double time_step)
      : Motion({start.pose, {{towed.speed, 0.0, 0.0}, {}}}), whole_step_{towed.speed * time_step, 0.0, 0.0} {}

  State after(double share) const override {
    State then = now_;
    then.pose.position += share * whole_step_;
    return then;
  }
  Vec2 course() const override { return plan(now_.twist.linear); }

 private:
  Vec3 whole_step_;  ///< [m]
};

/// Along a path. Contacts see the mean velocity of the step.
class OnPath final : public Motion {
 public:
  OnPath(const model::Towed& towed, double time_step) : Motion({}), path_(towed.path), time_step_(time_step) {
    now_ = {path_.at(0.0), mean_twist()};
  }

  State after(double share) const override { return {path_.at((elapsed_ + share) * time_step_), mean_twist()}; }
  void advance(double share) override {
    Motion::advance(share);
    elapsed_ += share;
  }
  Vec2 course() const override { return way_ahead(now_); }
  void save(model::Checkpoint& checkpoint) const override {
    Motion::save(checkpoint);
    model::save(checkpoint, "path", *this);
  }
  void restore(const model::Checkpoint& checkpoint) override {
    Motion::restore(checkpoint);
    model::restore(checkpoint, "path", *this);
  }

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("elapsed", "1", "steps done, parts of one included", self.elapsed_);
  }

 private:
  /// Of the step in which the structure is.
  Twist mean_twist() const {
    const double from = std::floor(elapsed_);
    return way_to(path_.at((from + 1.0) * time_step_), path_.at(from * time_step_), time_step_).twist;
  }

  Path path_;
  double time_step_;      ///< [s]
  double elapsed_ = 0.0;  ///< in steps
};

/// A mass on a spring and a dashpot in plan. The ice's load of one step acts, evenly, in the next one; the motion under
/// that load is exact. Within a step the structure goes at the step's mean velocity.
/// @see docs/theory/structures.md, (S6)
class Compliant final : public Motion {
 public:
  Compliant(const model::Compliant& compliant, const State& start, double time_step)
      : Motion({start.pose, {{compliant.speed, 0.0, 0.0}, {}}}),
        compliant_(compliant),
        time_step_(time_step),
        foot_(plan(start.pose.position)) {}

  State after(double share) const override {
    State then = now_;
    then.pose.position += share * time_step_ * now_.twist.linear;
    return then;
  }
  void advance(double share) override {
    Motion::advance(share);
    foot_.x += share * time_step_ * compliant_.speed;
  }
  void bear(const Wrench& load) override {
    const Vec2 rest = plan(load.force) / compliant_.stiffness, stretch = plan(now_.pose.position) - foot_;
    const double decay = 0.5 * compliant_.damping / compliant_.mass, stiff = compliant_.stiffness / compliant_.mass;
    const auto [fade, c, s] = free_motion(stiff, decay, time_step_);
    const Vec2 from_rest = stretch - rest;
    const Vec2 next = rest + fade * ((c + decay * s) * from_rest + s * velocity_);
    velocity_ = fade * ((c - decay * s) * velocity_ - stiff * s * from_rest);
    const Vec2 mean = Vec2{compliant_.speed, 0.0} + (next - stretch) / time_step_;
    now_.twist.linear = {mean.x, mean.y, 0.0};
  }
  Vec2 course() const override { return {compliant_.speed, 0.0}; }
  std::vector<NaturalMode> natural_modes() const override {
    const double stiff = compliant_.stiffness / compliant_.mass;
    return {{"surge", stiff}, {"sway", stiff}};
  }
  void save(model::Checkpoint& checkpoint) const override {
    Motion::save(checkpoint);
    model::save(checkpoint, "compliance", *this);
  }
  void restore(const model::Checkpoint& checkpoint) override {
    Motion::restore(checkpoint);
    model::restore(checkpoint, "compliance", *this);
  }

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("foot_", "m", "where the spring is slack", self.foot_);
    visit("velocity_", "m s-1", "against the foot, at the end of the coming step", self.velocity_);
  }

 private:
  /// How an oscillator moves freely: q = fade ((c + decay s) q0 + s v0).
  struct FreeMotion {
    double fade, c, s;
  };

  /// Underdamped, c and s are the cosine of f t and its sine over f. Overdamped, cosh and sinh overflow, so `fade` has
  /// their growth: it is the slow exponential.
  static FreeMotion free_motion(double stiff, double decay, double time) {
    const double squared = stiff - decay * decay, frequency = std::sqrt(std::abs(squared));
    const double angle = frequency * time, fade = std::exp(-decay * time);
    if (angle < 1e-6) return {fade, 1.0, time};
    if (squared > 0.0) return {fade, std::cos(angle), std::sin(angle) / frequency};
    return {std::exp(-stiff / (decay + frequency) * time), 0.5 * (1.0 + std::exp(-2.0 * angle)),
            -0.5 * std::expm1(-2.0 * angle) / frequency};
  }

  model::Compliant compliant_;
  double time_step_;  ///< [s]
  Vec2 foot_{};       ///< where the spring is slack [m]
  Vec2 velocity_{};   ///< against the foot, at the end of the coming step [m/s]
};

/// As another program says, step by step; without a word of it, on at the last twist.
class Driven final : public Motion {
 public:
  Driven(const model::Driven& driven, const State& start, double time_step)
      : Motion({start.pose, {{driven.speed, 0.0, 0.0}, {}}}), time_step_(time_step) {
    go_on();
  }

  State after(double share) const override {
    return {{now_.pose.position + share * way_.linear, turned(now_.pose.rotation, share * way_.angular)}, now_.twist};
  }
  void drive(const State& goal) override {
    const Quaternion& q = goal.pose.rotation;
    const double size = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    if (!is_finite(goal.pose.position) || !is_finite(goal.twist.linear) || !is_finite(goal.twist.angular))
      throw InputError("a pose or a twist that drives the structure is not finite");
    if (!(std::abs(size - 1.0) < kUnit))
      throw InputError("a rotation that drives the structure is not a unit quaternion: its norm is " +
                       std::to_string(size));
    const Twist way{goal.pose.position - now_.pose.position, turn_between(now_.pose.rotation, q)};
    expect_slow(way, time_step_, "a pose that drives the structure");
    expect_slow(goal.twist, 1.0, "a twist that drives the structure");
    way_ = way;
    now_.twist = goal.twist;
  }
  void bear(const Wrench& /*load*/) override { go_on(); }
  Vec2 course() const override { return way_ahead(now_); }
  void save(model::Checkpoint& checkpoint) const override {
    Motion::save(checkpoint);
    model::save(checkpoint, "drive", *this);
  }
  void restore(const model::Checkpoint& checkpoint) override {
    Motion::restore(checkpoint);
    model::restore(checkpoint, "drive", *this);
  }

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("way_", "m", "path of the origin in the coming step", self.way_.linear);
    visit("turn_", "rad", "turn in the coming step", self.way_.angular);
  }

 private:
  /// @param time  in which the structure goes this way [s].
  static void expect_slow(const Twist& way, double time, const std::string& what) {
    if (norm(way.linear) > kFastest * time)
      throw InputError(what + " moves it at " + std::to_string(norm(way.linear) / time) +
                       " m/s: more than 50 m/s; give metres, and the pose at the end of the step that comes, or at its "
                       "beginning to a co-simulation unit");
    if (norm(way.angular) > kFastestTurn * time)
      throw InputError(
          what + " turns it at " + std::to_string(norm(way.angular) / time) +
          " rad/s: more than 10 rad/s; give radians, and the pose at the end of the step that comes, or at "
          "its beginning to a co-simulation unit");
  }
  void go_on() { way_ = {time_step_ * now_.twist.linear, time_step_ * now_.twist.angular}; }

  /// A quaternion that is farther than this from a unit one is a mistake; nearer ones are rounded [-].
  static constexpr double kUnit = 1e-6;
  static constexpr double kFastest = 50.0;      // m/s, as the most of structure.speed
  static constexpr double kFastestTurn = 10.0;  // rad/s; a small buoy rolls at 2 rad/s

  double time_step_;  ///< [s]
  Twist way_{};       ///< of the coming step [m], [rad]
};

/// Joins the motions of a case to their makers.
struct Maker {
  const model::Case& resolved;
  const Hull& hull;
  double time_step = resolved.time.step;
  State at_rest{unresisted(resolved.structure, 0.0), {}};

  std::unique_ptr<Motion> operator()(const model::Towed& towed) const {
    if (!towed.path.empty()) return std::make_unique<OnPath>(towed, time_step);
    return std::make_unique<Towed>(towed, at_rest, time_step);
  }
  std::unique_ptr<Motion> operator()(const model::Compliant& compliant) const {
    return std::make_unique<Compliant>(compliant, at_rest, time_step);
  }
  std::unique_ptr<Motion> operator()(const model::Free& free) const { return body(free, {}); }
  std::unique_ptr<Motion> operator()(const model::Moored& moored) const { return body(moored, moored); }
  std::unique_ptr<Motion> operator()(const model::Driven& driven) const {
    return std::make_unique<Driven>(driven, at_rest, time_step);
  }

  /// At the start a body goes as its case says, and a mooring's feet go with it.
  std::unique_ptr<Motion> body(const auto& motion, const std::optional<model::Moored>& moored) const {
    const State start{at_rest.pose, {{motion.speed, 0.0, 0.0}, {}}};
    return std::make_unique<BodyMotion>(
        motion.body, moored, start,
        BodyMotion::Surroundings{hull, resolved.water.density, current_past_ice(resolved), time_step});
  }
};

}  // namespace

State way_to(const Pose& goal, const Pose& start, double time) {
  return {goal, {(goal.position - start.position) / time, turn_between(start.rotation, goal.rotation) / time}};
}

State way_at(const Twist& twist, const Pose& start, double time) {
  return {{start.position + time * twist.linear, turned(start.rotation, time * twist.angular)}, twist};
}

void Motion::drive(const State& /*goal*/) {
  throw InputError(Complaint{"structure.motion.kind", "does not let another program drive the structure", "driven",
                             "write structure.motion.kind = \"driven\""});
}

void Motion::save(model::Checkpoint& checkpoint) const { model::save(checkpoint, "structure", now_); }

void Motion::restore(const model::Checkpoint& checkpoint) { model::restore(checkpoint, "structure", now_); }

std::unique_ptr<Motion> make_motion(const model::Case& resolved, const Hull& hull) {
  return std::visit(Maker{resolved, hull}, resolved.structure.motion);
}

Pose unresisted(const model::StructureSection& structure, double time) {
  const auto* const towed = std::get_if<model::Towed>(&structure.motion);
  if (towed != nullptr && !towed->path.empty()) return Path(towed->path).at(time);
  return {{-structure.start_distance + model::speed(structure.motion) * time, 0.0, 0.0}, {}};
}

double last_axis(const model::StructureSection& structure, const Pose& pose) {
  if (structure.legs.empty()) return pose.position.x;
  double last = std::numeric_limits<double>::infinity();
  for (const Vec2 leg : structure.legs) last = std::min(last, to_world(pose, {leg.x, leg.y, 0.0}).x);
  return last;
}

double mean_speed(const model::StructureSection& structure, double time) {
  if (const double speed = model::speed(structure.motion); speed > 0.0) return speed;
  constexpr int kChords = 400;
  double way = 0.0;
  for (int i = 0; i < kChords; ++i)
    way += norm(unresisted(structure, time * (i + 1) / kChords).position -
                unresisted(structure, time * i / kChords).position);
  return way / time;
}

}  // namespace brash::structure
