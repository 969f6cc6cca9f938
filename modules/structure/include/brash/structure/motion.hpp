// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "brash/core/vec.hpp"
#include "brash/model/case.hpp"
#include "brash/model/checkpoint.hpp"
#include "brash/model/records.hpp"
#include "brash/structure/hull.hpp"

namespace brash::structure {

/// Roll, pitch and heading of a rotation [rad]: it turns by the heading about z first, then by the pitch about its own
/// y, and by the roll about its own x last.
inline Vec3 attitude_of(const Quaternion& q) {
  return {std::atan2(2.0 * (q.w * q.x + q.y * q.z), 1.0 - 2.0 * (q.x * q.x + q.y * q.y)),
          std::asin(std::clamp(2.0 * (q.w * q.y - q.x * q.z), -1.0, 1.0)),
          std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z))};
}

/// Where a structure is, and how it moves, world frame.
struct State {
  Pose pose;
  Twist twist;  ///< of the pose's origin

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    model::visit_pose(self.pose, visit);
    model::visit_twist(self.twist, visit);
  }
};

/// At `goal`, after `time` [s] of an even motion from `start`.
State way_to(const Pose& goal, const Pose& start, double time);
/// At the end of `time` [s] of the motion `twist` from `start`.
State way_at(const Twist& twist, const Pose& start, double time);

/// A free oscillation of a structure on its restoring loads: small, undamped, about the pose at the start.
struct NaturalMode {
  const char* motion = "";         ///< that it is most of: surge, sway, heave, roll, pitch or yaw
  double squared_frequency = 0.0;  ///< omega^2 [1/s2]; below 0: the structure does not come back
};

/// The way of a body from its pose at the start to the pose where its loads balance, without ice and damping: the
/// first step of Newton's method in heave, roll and pitch.
struct Settling {
  double heave = 0.0;              ///< of the centre of gravity, upwards [m]
  double roll = 0.0, pitch = 0.0;  ///< about x and y [rad]
};

/// How a structure moves: a load goes in, a pose and a twist come out. Time passes in steps of one length, which may
/// be taken in parts.
class Motion {
 public:
  explicit Motion(const State& start) : now_(start) {}
  virtual ~Motion() = default;

  const State& now() const { return now_; }

  /// Where the structure is when `share` of a step [-] has passed from now.
  virtual State after(double share) const = 0;

  /// Goes there.
  virtual void advance(double share) { now_ = after(share); }

  /// Takes the mean load of the step that ends now: of the ice on the structure, about its origin, world axes. A
  /// prescribed motion does not heed it.
  virtual void bear(const Wrench& /*load*/) {}

  /// Where the structure goes in the coming step, if it is driven from outside: to `pose`, straight and with an even
  /// turn, while contacts see it move at `twist`. Without a call it continues at its last twist.
  /// @throws InputError when the case has another motion, or a value is not finite or no rotation, or the structure
  /// would move faster than 50 m/s or turn faster than 10 rad/s.
  virtual void drive(const State& goal);

  /// The way ahead in plan, of any length: along the velocity through the ice where nothing resists. A structure that
  /// has none looks along its x axis.
  virtual Vec2 course() const = 0;

  /// Energies after the last bear(), of a structure that is a body; all zero of another.
  virtual model::BodyEnergy energy() const { return {}; }

  /// The modes that something restores, the slowest first; none of a prescribed motion. docs/theory/structures.md,
  /// (B12).
  virtual std::vector<NaturalMode> natural_modes() const { return {}; }

  /// Nothing of a motion without heave. docs/theory/structures.md, (B13).
  virtual Settling settling() const { return {}; }

  /// Saves in a table of its own all that the motion from now on depends on.
  virtual void save(model::Checkpoint& checkpoint) const;
  virtual void restore(const model::Checkpoint& checkpoint);

 protected:
  State now_;
};

/// The motion of a case's structure from its start.
/// @param hull  of the structure; a body keeps a reference to it.
/// @throws InputError when a body cannot float, or the step is too long for it.
std::unique_ptr<Motion> make_motion(const model::Case& resolved, const Hull& hull);

/// Where a structure is at `time` [s], if nothing resists it and no one drives it: on its path, or along x at its
/// speed.
Pose unresisted(const model::StructureSection& structure, double time);

/// x of the structure's axis at a pose, and of its last leg if it has legs [m].
double last_axis(const model::StructureSection& structure, const Pose& pose);

/// Mean speed from the start to `time` [m/s], if nothing resists the structure and no one drives it; along a path from
/// 400 chords.
double mean_speed(const model::StructureSection& structure, double time);

}  // namespace brash::structure
