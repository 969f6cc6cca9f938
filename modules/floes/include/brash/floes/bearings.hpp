// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "brash/floes/bearing.hpp"
#include "brash/floes/floe_population.hpp"
#include "brash/model/checkpoint.hpp"

namespace brash::floes {

/// The loads of awake floes on the edges of level ice, each averaged over its floe's collision time.
class Bearings {
 public:
  /// The floe's body, and the number of the level ice.
  using Pair = std::pair<BodyId, int>;

  /// Averages over a step of `dt` [s].
  /// @param contacts      contacts_by_place().
  /// @param level_ice_of  number of the level ice that a body of the sheet belongs to.
  /// @param in_sheet  a contact with level ice, in the frame of that ice; empty: it is the world's.
  void average(const rigid_body::World& world, const FloePopulation& floes,
               const std::vector<const rigid_body::ContactLoad*>& contacts,
               const std::function<std::optional<int>(BodyId)>& level_ice_of, double dt,
               const std::function<rigid_body::ContactLoad(int, const rigid_body::ContactLoad&)>& in_sheet = {});

  /// The floe no longer exists.
  void forget(BodyId floe);
  /// Level ice number `level_ice` has broken within `radius` of `at`.
  void forget_within(int level_ice, Vec2 at, double radius);
  /// Its ice in a box has come loose.
  void forget_within(int level_ice, const geometry::Extent& box);

  /// Sorted by floe, then by level ice.
  const std::map<Pair, Bearing>& all() const { return mean_; }

  void save(const FloePopulation& floes, model::Checkpoint& checkpoint) const;
  void restore(const FloePopulation& floes, const model::Checkpoint& checkpoint);

 private:
  std::map<Pair, Bearing> mean_;
};

}  // namespace brash::floes
