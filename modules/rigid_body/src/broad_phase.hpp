// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>

#include <cstdint>
#include <vector>

#include "body.hpp"

namespace brash::rigid_body {

/// Two parts whose boxes overlap; `first` is a floe's, and one of them is that of a floe which moves.
struct PartPair {
  Part* first = nullptr;
  Part* second = nullptr;
};

/// Two parts of different bodies, at least one of them that of a floe which moves.
struct NearPair {
  Part* one = nullptr;
  Part* other = nullptr;
  bool overlap = false;  ///< of their boxes
};

/// A tree of the parts' boxes (Bullet's btDbvtBroadphase).
class BroadPhase {
 public:
  BroadPhase() = default;
  ~BroadPhase();
  BroadPhase(const BroadPhase&) = delete;
  BroadPhase& operator=(const BroadPhase&) = delete;

  void add(Part& part);
  void remove(Part& part);
  void move(Part& part);
  /// Overlapping pairs with at least one floe that moves, sorted by (rank, part) of the first and the second body.
  /// Boxes are compared in full precision, so the answer is a function of the boxes and not of the tree's history.
  const std::vector<PartPair>& pairs();
  /// How near the boxes of a pair may be to be known to near_pairs() [m]; from the next move of the parts on.
  double reach = 0.0;
  /// Pairs whose boxes come within the reach of each other, in no order.
  const std::vector<NearPair>& near_pairs();

 private:
  /// A pair with the places of its parts in the order of the step.
  struct Ordered {
    std::uint64_t first;
    std::uint64_t second;
    PartPair pair;
  };

  btDbvtBroadphase tree_;
  bool known_ = false;  ///< near_, of the parts where they are now
  std::vector<NearPair> near_;
  std::vector<PartPair> pairs_;
  std::vector<Ordered> ordered_;  ///< scratch of pairs
};

}  // namespace brash::rigid_body
