// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <utility>

#include "brash/core/ids.hpp"
#include "brash/core/vec.hpp"
#include "brash/rigid_body/world.hpp"

namespace brash::floes {

/// The mean force of the floe `other` on the floe `floe`, both by Floe::id [N].
struct FloePush {
  std::int64_t floe = 0;
  std::int64_t other = 0;
  Vec3 force{};

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("floe", "1", "floe_id of the pushed floe", self.floe);
    visit("other", "1", "floe_id of the pushing floe", self.other);
    visit("force_", "N", "mean force", self.force);
  }
};

/// Mean forces between floes that touch. They decide which floes sleep and wake (docs/theory/simulation.md, (S2)).
/// Nothing is known of a pair while both are asleep: it keeps the mean that it had, and costs a step nothing.
class MeanPushes {
 public:
  using Pair = std::pair<BodyId, BodyId>;  ///< the lower id first

  /// Reports by how much the mean push on a floe has changed [N].
  using Tell = std::function<void(BodyId floe, Vec3 change)>;

  /// Takes in the contacts of the last step, and reports the changes for floes that are asleep. Floes that
  /// have woken since the last call are known to wake().
  /// @param share  weight of the step, dt over the time of averaging [-].
  /// @param least  a mean smaller than this is forgotten [N].
  void average(const rigid_body::World& world, double share, double least, const Tell& tell);

  /// A floe has woken.
  void wake(BodyId floe);

  /// Takes a floe out, and reports the changes for the floes that it pushed.
  void forget(BodyId floe, const Tell& tell);

  /// The mean force of the second floe of each pair on the first [N].
  std::map<Pair, Vec3> pairs() const;
  void restore(BodyId floe, BodyId other, Vec3 force) { moving_[{floe, other}] = force; }

 private:
  std::map<Pair, Vec3> moving_;  ///< pairs of which a floe moves, or did in the last step
  std::map<Pair, Vec3> resting_;
};

}  // namespace brash::floes
