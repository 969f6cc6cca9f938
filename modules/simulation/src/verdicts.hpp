// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "brash/model/checkpoint.hpp"
#include "edge_contact.hpp"

namespace brash::simulation {

/// What the last solution of each contact's sheet said, and under which load. Stresses grow with the loads, so it
/// predicts the stress of the step that follows.
/// @see docs/theory/simulation.md, (S5)
class Verdicts {
 public:
  /// Stress over strength of a contact, when its sheet was solved and now.
  struct Growth {
    double before = 0.0, now = 0.0;
  };
  /// Of the structure's contact that is most stressed now, while floes press as before; nothing if none was solved.
  /// Contacts that held above the strength are left out: more load need not break them.
  std::optional<Growth> most_stressed(const std::vector<EdgeContact>& of_structure) const;

  /// Keeps these verdicts in place of those before.
  void keep(const std::vector<EdgeContact>& contacts);

  /// The level ice has broken within `radius` of `at`, or its ice in a box has come loose.
  void forget_within(int level_ice, Vec2 at, double radius);
  void forget_within(int level_ice, const geometry::Extent& box);

  void save(model::Checkpoint& checkpoint) const;
  void restore(const model::Checkpoint& checkpoint);

 private:
  struct Kept {
    std::int64_t level_ice = 0;
    std::int64_t floe = model::kNoFloe;
    Touch touched{};
    double ratio = 0.0;   ///< stress over strength
    Pressing pressing{};  ///< that it was found under

    template <typename Self, typename Visit>
    static void visit(Self& self, Visit&& visit) {
      visit("level_ice", "1", "number of the level ice", self.level_ice);
      visit("floe", "1", "that presses; -1: the structure", self.floe);
      visit("tip_", "m", "middle of the chord", self.touched.tip);
      visit("length", "m", "of the chord", self.touched.length);
      visit("ratio", "1", "stress over strength", self.ratio);
      visit("by_structure", "N", "the structure's loads that bent the ice there", self.pressing.by_structure);
      visit("by_floes", "N", "likewise the floes'", self.pressing.by_floes);
    }
  };
  const Kept* find(const EdgeContact& contact) const;

  std::vector<Kept> kept_;
};

}  // namespace brash::simulation
