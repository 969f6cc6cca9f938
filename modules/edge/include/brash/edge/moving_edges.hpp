// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "brash/edge/edge_contact.hpp"
#include "brash/failure/edge_motion.hpp"
#include "brash/model/checkpoint.hpp"

namespace brash::edge {

/// The free edges that the structure presses on, each from its first touch until the ice breaks or the structure lets
/// go. They give way under their load, and remember it.
/// @see docs/theory/simulation.md, (S4)
class MovingEdges {
 public:
  /// @param dynamics  of each level ice; empty: edges do not move.
  explicit MovingEdges(std::vector<failure::EdgeDynamics> dynamics) : dynamics_(std::move(dynamics)) {}

  /// How far the edge that is touched will have given way at a time, if its load continues as before: along the
  /// way in which it is pushed, negative for down [m].
  double shift(int level_ice, const Touch& touched, double time) const;

  /// Largest shift in size [m], with its sign.
  double largest_shift(int level_ice, double time) const;

  /// The contacts of the structure have loaded the edges from one time to the other [s]. Edges that it does not touch
  /// any more are forgotten. An edge takes no more work than the structure has done on it: a contact whose force would
  /// push its edge farther carries less.
  /// @param work  of the structure on each contact, under its whole force [J]. @return the work that bent edges [J].
  double follow(std::vector<EdgeContact>& contacts, std::span<const double> work, double from, double to);

  /// Where the edge of a contact is in its life.
  struct Life {
    double age = 0.0;         ///< since the first touch [s]
    double deflection = 0.0;  ///< >= 0 as pushed [m]
  };
  /// Nothing where the edge does not move.
  std::optional<Life> life(const EdgeContact& contact) const;

  /// How the edge of a contact moves.
  failure::EdgeMotion motion(const EdgeContact& contact) const;

  /// There is more level ice, of the kind of another one.
  void add_level_ice(int like) {
    if (!dynamics_.empty()) dynamics_.push_back(failure::EdgeDynamics(dynamics_[static_cast<std::size_t>(like)]));
  }

  /// The ice of a contact has broken.
  void forget(const EdgeContact& contact);
  /// The level ice has broken within `radius` of `at`.
  void forget_within(int level_ice, Vec2 at, double radius);
  /// Its ice in a box has come loose.
  void forget_within(int level_ice, const geometry::Extent& box);

  void save(model::Checkpoint& checkpoint) const;
  void restore(const model::Checkpoint& checkpoint);

 private:
  /// An edge that is pressed.
  struct Edge {
    int level_ice = 0;
    double touched_at = 0.0;  ///< first [s]
    Touch touched{};
    double way = -1.0;          ///< -1: pushed down, 1: up
    double deflection = 0.0;    ///< at the end of the history, >= 0 as pushed [m]
    double spare = 0.0;         ///< work that the structure has done on it and that has not bent it [J], >= 0
    failure::LoadCase shape{};  ///< its trapezoid
    failure::EdgeHistory history;
    double thickness = 0.0;  ///< of the ice at the first touch [m]
    failure::EdgeDynamics dynamics;
  };

  /// Of ice of a thickness [m].
  failure::EdgeDynamics dynamics(int level_ice, double thickness) const {
    return dynamics_[static_cast<std::size_t>(level_ice)].of_thickness(thickness);
  }
  const Edge* edge_at(int level_ice, const Touch& touched) const;
  Edge take_over(const EdgeContact& contact, double from);
  static double load(Edge& edge, EdgeContact& contact, double work, double to);

  std::vector<failure::EdgeDynamics> dynamics_;  ///< of the mean thickness
  std::vector<Edge> edges_;
};

}  // namespace brash::edge
