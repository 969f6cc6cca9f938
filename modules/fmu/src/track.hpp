// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "brash/core/vec.hpp"
#include "brash/fmu/variables.hpp"

namespace brash::fmu {

/// Where a host has put a driven structure step by step, and where its velocities would have led it.
///
/// Contacts see the velocity, and the place follows the pose. A host that gives only one of the two gets loads that
/// look right and are not. At equal times both lead to the same place, but for the rounding of a host that gives the
/// velocity at the start or the end of a step: that stays within two strides, however long the run is.
class Track {
 public:
  /// Takes the inputs of the next step of the host.
  /// @param size  of that step [s].
  void add(const Inputs& inputs, double size);

  /// The mean velocity of the last step, from its poses; none before the second step.
  std::optional<Twist> mean_twist(const Inputs& now) const;

  /// A sentence when poses and velocities part, at the first time alone; else empty.
  std::string take_warning();

  /// In how many steps they parted; empty where they never did so far that there was a warning.
  std::string count() const;

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    Inputs::visit(self.last_, visit);
    visit("size", "s", "of the last step", self.size_);
    for (auto* const part : {&self.moved_, &self.turned_}) {
      visit("gap_x", "m or rad", "between the sums of both", part->gap.x);
      visit("gap_y", "m or rad", "between the sums of both", part->gap.y);
      visit("gap_z", "m or rad", "between the sums of both", part->gap.z);
      visit("path", "m or rad", "length of the longer one", part->path);
      visit("stride", "m or rad", "largest of a step", part->stride);
    }
    visit("n_steps", "1", "of the host", self.n_steps_);
    visit("n_apart", "1", "steps in which both part", self.n_apart_);
    visit("has_warned", "1", "whether it has", self.has_warned_);
  }

 private:
  /// Ways, or turns.
  struct Part {
    Vec3 gap{};
    double path = 0.0, stride = 0.0;

    /// @return whether both part in this step.
    bool add(const Vec3& by_pose, const Vec3& by_velocity, const Vec3& missed);
    bool is_apart() const;
  };

  Inputs last_{};
  double size_ = 0.0;
  Part moved_{}, turned_{};
  double n_steps_ = 0.0, n_apart_ = 0.0, has_warned_ = 0.0;  ///< numbers, as a state holds them
};

/// The pose of inputs: turned by the yaw, then the pitch, then the roll, each about the structure's own axis.
Pose pose_of(const Inputs& inputs);

}  // namespace brash::fmu
