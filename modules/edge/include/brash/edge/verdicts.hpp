// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "brash/edge/edge_contact.hpp"
#include "brash/model/checkpoint.hpp"
#include "brash/model/records.hpp"

namespace brash::edge {

/// The answer of the last solution of each contact's sheet, and its load. Stresses grow with the loads, so it
/// predicts the stress of the steps that follow. Contacts far from breaking are solved from time to time only.
/// @see docs/theory/simulation.md, (S7), (S6)
class Verdicts {
 public:
  /// @param lateness  longest time between two solutions of a contact's sheet [s]; 0: none is kept.
  explicit Verdicts(double lateness) : lateness_(lateness) {}

  /// Overload of a contact (failure::Assessment), when its sheet was solved and now.
  struct Growth {
    double before = 0.0, now = 0.0;
  };
  /// Of the structure's most overloaded contact, while floes press as before; nothing if none was solved. Contacts
  /// that held above 1 are left out: more load need not break them.
  std::optional<Growth> most_overloaded(const std::vector<EdgeContact>& of_structure) const;

  /// Gives contacts that need no solution now their verdict; EdgeContact::kept.
  /// @param now  [s].
  void recall(double now, std::vector<EdgeContact>& contacts) const;

  /// Keeps these verdicts in place of those before. @return how many were recalled, and how many late.
  model::KeptCounts keep(double now, const std::vector<EdgeContact>& contacts);

  /// The level ice has broken within `radius` of `at`. Beyond it, up to `around`, contacts are to be solved.
  void forget_within(int level_ice, Vec2 at, double radius, double around);
  /// Its ice in a box has come loose.
  void forget_within(int level_ice, const geometry::Extent& box);

  void save(model::Checkpoint& checkpoint) const;
  void restore(const model::Checkpoint& checkpoint);

 private:
  struct Kept {
    std::int64_t level_ice = 0;
    std::int64_t floe = model::kNoFloe;
    Touch touched{};
    double time = 0.0;             ///< of the solution [s]
    double overload = 0.0;         ///< failure::Assessment::overload
    double stress = 0.0;           ///< [Pa]
    double breaking_length = 0.0;  ///< [m]
    Pressing pressing{};           ///< that it was found under
    bool is_bound = false;         ///< the overload is at most so large
    bool is_stale = false;         ///< the ice around it has changed
    bool is_control = false;       ///< solved in every step, to count misses
    double fails_from = -1.0;      ///< the first failure of the control since then [s]; negative: none

    double growth(const Pressing& now) const { return now.sum() / pressing.sum(); }

    template <typename Self, typename Visit>
    static void visit(Self& self, Visit&& visit) {
      visit("level_ice", "1", "number of the level ice", self.level_ice);
      visit("floe", "1", "that presses; -1: the structure", self.floe);
      visit("tip_", "m", "middle of the chord", self.touched.tip);
      visit("length", "m", "of the chord", self.touched.length);
      visit("time", "s", "time of the solution", self.time);
      visit("overload", "1", "loads over those at which the ice fails", self.overload);
      visit("stress", "Pa", "largest stress", self.stress);
      visit("breaking_length", "m", "breaking length", self.breaking_length);
      visit("by_structure", "N", "the structure's loads that bent the ice there", self.pressing.by_structure);
      visit("by_floes", "N", "the same of the floes", self.pressing.by_floes);
      visit("up", "N", "vertical loads among them, upwards", self.pressing.up);
      visit("down", "N", "vertical loads among them, downwards", self.pressing.down);
      visit("is_bound", "1", "whether the overload is a bound", self.is_bound);
      visit("is_stale", "1", "whether the ice around it has changed", self.is_stale);
      visit("is_control", "1", "whether it is solved in every step", self.is_control);
      visit("fails_from", "s", "first failure of the control; negative: none", self.fails_from);
    }
  };
  const Kept* find(const EdgeContact& contact) const;
  bool may_keep(const Kept& kept, const EdgeContact& contact, double now) const;

  double lateness_;
  std::vector<Kept> kept_;
};

}  // namespace brash::edge
