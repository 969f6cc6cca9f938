// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/structure/motion.hpp"

namespace brash::structure {
namespace {

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

void Motion::save(model::Checkpoint& checkpoint) const { model::save(checkpoint, "structure", now_); }

void Motion::restore(const model::Checkpoint& checkpoint) { model::restore(checkpoint, "structure", now_); }

std::unique_ptr<Motion> make_motion(const model::StructureSection& structure, double time_step) {
  const State start{{{-structure.start_distance, 0.0, 0.0}, {}}, {}};
  return std::visit([&](const auto& motion) { return motion_of(motion, start, time_step); }, structure.motion);
}

}  // namespace brash::structure
