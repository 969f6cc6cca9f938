// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/structure/motion.hpp"

namespace brash::structure {
namespace {

/// Visits every number of a state with its name in a checkpoint.
template <typename AnyState, typename Visit>
void visit_numbers(AnyState& state, Visit&& visit) {
  visit("structure_x", state.pose.position.x);
  visit("structure_y", state.pose.position.y);
  visit("structure_z", state.pose.position.z);
  visit("structure_qw", state.pose.rotation.w);
  visit("structure_qx", state.pose.rotation.x);
  visit("structure_qy", state.pose.rotation.y);
  visit("structure_qz", state.pose.rotation.z);
  visit("structure_vx", state.twist.linear.x);
  visit("structure_vy", state.twist.linear.y);
  visit("structure_vz", state.twist.linear.z);
  visit("structure_wx", state.twist.angular.x);
  visit("structure_wy", state.twist.angular.y);
  visit("structure_wz", state.twist.angular.z);
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

std::unique_ptr<Motion> motion_of(const model::Towed& towed, const State& start, double time_step) {
  return std::make_unique<Towed>(towed, start, time_step);
}

}  // namespace

void Motion::save(Numbers& numbers) const {
  visit_numbers(now_, [&](const char* name, double number) { numbers[name] = number; });
}

void Motion::restore(const Numbers& numbers) {
  visit_numbers(now_, [&](const char* name, double& number) { number = numbers.at(name); });
}

std::unique_ptr<Motion> make_motion(const model::StructureSection& structure, double time_step) {
  const State start{{{-structure.start_distance, 0.0, 0.0}, {}}, {}};
  return std::visit([&](const auto& motion) { return motion_of(motion, start, time_step); }, structure.motion);
}

}  // namespace brash::structure
