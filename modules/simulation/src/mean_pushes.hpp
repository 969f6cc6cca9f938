// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <utility>

#include "brash/core/ids.hpp"
#include "brash/core/vec.hpp"
#include "brash/rigid_body/world.hpp"

namespace brash::simulation {

/// Mean forces between floes that touch, for what fixes floes and lets them go (docs/theory/simulation.md, (S2)).
/// Nothing is known of a pair while both are settled: it keeps the mean that it had.
class MeanPushes {
 public:
  /// Takes in the contacts of the last step.
  /// @param share  weight of the step, dt over the time of averaging [-].
  /// @param least  a mean smaller than this is forgotten [N].
  void average(const rigid_body::World& world, double share, double least);

  /// What each floe is pushed with by all others [N]; floes that nothing pushes are left out.
  std::map<BodyId, Vec3> on_floes() const;

  void forget(BodyId floe);

  /// The mean force of the second floe of each pair on the first [N].
  const std::map<std::pair<BodyId, BodyId>, Vec3>& pairs() const { return pairs_; }
  void restore(BodyId floe, BodyId other, Vec3 force) { pairs_[{floe, other}] = force; }

 private:
  std::map<std::pair<BodyId, BodyId>, Vec3> pairs_;  ///< the lower id first
};

}  // namespace brash::simulation
