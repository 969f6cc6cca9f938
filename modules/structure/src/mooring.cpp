// SPDX-License-Identifier: GPL-3.0-or-later
// docs/theory/structures.md, (B10).
#include "mooring.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>

#include "brash/core/error.hpp"
#include "catenary.hpp"
#include "rotation.hpp"

namespace brash::structure {
namespace {

/// The moment with the same power as `force` on the rate of the rotation vector `turn`: the transpose of the inverse
/// left Jacobian of the rotation.
Vec3 moment_of(Vec3 force, Vec3 turn) {
  const double angle = norm(turn);
  const double k =
      angle < 1e-3 ? 1.0 / 12.0 + angle * angle / 720.0 : (1.0 - 0.5 * angle / std::tan(0.5 * angle)) / (angle * angle);
  return force + 0.5 * cross(turn, force) + k * cross(turn, cross(turn, force));
}

}  // namespace

/// U = q.K q / 2 - q.p, with q the way of the origin and the rotation vector of the turn (B10).
MooringLoad Mooring::springs(const Pose& pose, Vec3 shift) const {
  const Vec3 way = pose.position - start_.position - shift, turn = turn_between(start_.rotation, pose.rotation);
  const std::array<double, 6> q{way.x, way.y, way.z, turn.x, turn.y, turn.z};
  std::array<double, 6> f{};
  double energy = 0.0;
  for (std::size_t i = 0; i < 6; ++i) {
    const double pretension = moored_.pretension.empty() ? 0.0 : moored_.pretension[i];
    double pull = 0.0;
    if (!moored_.stiffness.empty())
      for (std::size_t j = 0; j < 6; ++j) pull += moored_.stiffness[i][j] * q[j];
    f[i] = pretension - pull;
    energy += q[i] * (0.5 * pull - pretension);
  }
  return {{{f[0], f[1], f[2]}, moment_of({f[3], f[4], f[5]}, turn)}, energy};
}

MooringLoad Mooring::line(std::size_t index, const Pose& pose, Vec3 shift) const {
  const model::MooringLine& line = moored_.lines[index];
  const Vec3 anchor{start_.position.x + line.anchor.x + shift.x, start_.position.y + line.anchor.y + shift.y,
                    line.anchor.z};
  const Vec3 arm = rotate(pose.rotation, line.fairlead), away = pose.position + arm - anchor;
  if (away.z <= 0.0)
    throw RunError(fmt::format(
        "line {} of structure.motion.lines: its fairlead has come down to z = {:.6g} m, and its anchor lies "
        "at {:.6g} m. A line hangs from a fairlead above its anchor: lower the anchor, or stiffen what "
        "holds the structure up",
        index + 1, anchor.z + away.z, anchor.z));
  const double span = norm(plan(away));
  const LinePull pull = pull_of({line.length, line.weight, line.stiffness}, span, away.z);
  const Vec2 back = span > 0.0 ? -pull.horizontal / span * plan(away) : Vec2{};
  const Vec3 force{back.x, back.y, -pull.downward};
  return {{force, cross(arm, force)}, pull.energy};
}

MooringLoad Mooring::at(const Pose& pose, Vec3 shift) const {
  MooringLoad sum = springs(pose, shift);
  for (std::size_t i = 0; i < moored_.lines.size(); ++i) {
    const MooringLoad pulls = line(i, pose, shift);
    sum.load += pulls.load;
    sum.energy += pulls.energy;
  }
  return sum;
}

}  // namespace brash::structure
