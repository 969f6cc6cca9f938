// SPDX-License-Identifier: GPL-3.0-or-later
#include "track.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "brash/structure/motion.hpp"

namespace brash::fmu {
namespace {

/// Sums of poses and velocities may differ by this part of the path [-]: less changes a load by less than it scatters.
constexpr double kShare = 0.01;
/// And by so many of the largest strides: velocities may be of the start, the middle or the end of a step.
constexpr double kStrides = 2.0;
/// Both stand still where they go less than this in a step [m], [rad].
constexpr double kStill = 1e-9;

}  // namespace

Pose pose_of(const Inputs& in) {
  const double cr = std::cos(0.5 * in.roll), sr = std::sin(0.5 * in.roll);
  const double cp = std::cos(0.5 * in.pitch), sp = std::sin(0.5 * in.pitch);
  const double cy = std::cos(0.5 * in.yaw), sy = std::sin(0.5 * in.yaw);
  return {in.place,
          {cr * cp * cy + sr * sp * sy, sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy,
           cr * cp * sy - sr * sp * cy}};
}

bool Track::Part::add(const Vec3& by_pose, const Vec3& by_velocity, const Vec3& missed) {
  const double way = std::max(norm(by_pose), norm(by_velocity));
  gap += missed;
  path += way;
  stride = std::max(stride, way);
  return norm(missed) > kShare * way + kStill;
}

bool Track::Part::is_apart() const { return norm(gap) > kShare * path + kStrides * stride + kStill; }

std::optional<Twist> Track::mean_twist(const Inputs& now) const {
  if (size_ == 0.0) return std::nullopt;
  return structure::way_to(pose_of(now), pose_of(last_), size_).twist;
}

void Track::add(const Inputs& inputs, double size) {
  if (size_ > 0.0) {
    const Pose now = pose_of(inputs), before = pose_of(last_);
    const Pose led = structure::way_at(last_.twist, before, size_).pose;
    const Twist way = structure::way_to(now, before, 1.0).twist, missed = structure::way_to(now, led, 1.0).twist;
    const bool has_moved_apart = moved_.add(way.linear, size_ * last_.twist.linear, missed.linear);
    const bool has_turned_apart = turned_.add(way.angular, size_ * last_.twist.angular, missed.angular);
    n_apart_ += has_moved_apart || has_turned_apart ? 1.0 : 0.0;
    n_steps_ += 1.0;
  }
  last_ = inputs;
  size_ = size;
}

std::string Track::take_warning() {
  const bool is_moved_apart = moved_.is_apart();
  if (has_warned_ != 0.0 || !(is_moved_apart || turned_.is_apart())) return {};
  has_warned_ = 1.0;
  const Part& part = is_moved_apart ? moved_ : turned_;
  return fmt::format(
      "the structure's poses and {} do not fit: over a path of {:.3g} {} they part by {:.3g} {}. The load depends on "
      "both, so it is wrong. Connect {}, each the mean of the step that begins, or export the unit with "
      "--velocity-from-poses",
      is_moved_apart ? "velocities" : "angular velocities", part.path, is_moved_apart ? "m" : "rad", norm(part.gap),
      is_moved_apart ? "m" : "rad",
      is_moved_apart ? "structure_vx, structure_vy and structure_vz" : "structure_wx, structure_wy and structure_wz");
}

std::string Track::count() const {
  if (has_warned_ == 0.0) return {};
  return fmt::format("the structure's poses and velocities did not fit in {:.0f} of {:.0f} steps", n_apart_, n_steps_);
}

}  // namespace brash::fmu
